"""Writes statements of pbrt-v4's scene language, and knows which of them came from which object."""

import bisect
import re
import numbers

ERROR_PLACE = re.compile(r"([^\s:]*scene\.pbrt):(\d+):(\d+): ?")


class SceneFault(Exception):
    """What makes a scene impossible to render; the text is for the user."""


def quoted(text):
    """Returns text as a quoted string of the scene language."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + escaped.replace("\n", "\\n").replace("\r", "\\r").replace("\t", "\\t") + '"'


def number(value):
    """Returns a number in as few digits as give the same float."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    text = f"{float(value):.9g}"
    if text in ("nan", "inf", "-inf"):
        raise ValueError("a number that is not finite")
    return text


def in_comment(text):
    """Returns text on one line."""
    return "".join(c if c.isprintable() else " " for c in text)


def parameter(name, value):
    """Returns one parameter; name is "type name", value a text, a number, or a row of either."""
    row = [value] if isinstance(value, (str, numbers.Number)) else list(value)
    words = [quoted(v) if isinstance(v, str) else number(v) for v in row]
    return f'"{name}" [ {" ".join(words)} ]'


def columns(matrix):
    """Returns the 16 numbers of a 4 x 4 matrix (rows) column by column, as the language has it."""
    return "[ " + " ".join(number(matrix[row][column])
                           for column in range(4) for row in range(4)) + " ]"


class SceneText:
    """The lines of a scene file, with the names of what they describe."""

    def __init__(self):
        self.lines = []
        self.lights = []  # names, in the order in which the program numbers them
        self._starts = []
        self._names = []
        self._depth = 0

    def about(self, name):
        """What follows describes `name`, as "object Cube"."""
        if self._names and self._names[-1] == name:
            return
        self._starts.append(len(self.lines) + 1)
        self._names.append(name)
        self._add("# " + in_comment(name))

    def say(self, keyword, kind=None, parameters=None, rest=""):
        """Adds one statement on one line."""
        words = [keyword]
        if kind is not None:
            words.append(quoted(kind))
        if rest:
            words.append(rest)
        try:
            words += [parameter(name, value) for name, value in (parameters or {}).items()]
        except ValueError as fault:
            about = self._names[-1] if self._names else "scene"
            raise SceneFault(f"{about}: {keyword} has {fault}") from fault
        self._add(" ".join(words))

    def begin(self):
        self.say("AttributeBegin")
        self._depth += 1

    def end(self):
        self._depth -= 1
        self.say("AttributeEnd")

    def light(self, name, keyword, kind, parameters):
        """Adds a light and notes its number."""
        self.lights.append(name)
        self.say(keyword, kind, parameters)

    def name_at(self, line):
        """Returns what the line describes, or None."""
        index = bisect.bisect_right(self._starts, line) - 1
        return self._names[index] if index >= 0 else None

    def explain(self, message):
        """Returns a message of the program with the object's name for the place in the file."""
        place = ERROR_PLACE.search(message)
        if not place:
            return message
        name = self.name_at(int(place[2]))
        rest = message[:place.start()] + message[place.end():]
        return f"{name}: {rest}" if name else rest

    def text(self):
        return "\n".join(self.lines) + "\n"

    def _add(self, line):
        self.lines.append("  " * self._depth + line)
