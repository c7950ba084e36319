"""The exception of the package."""


class Error(RuntimeError):
    """What cannot be used or done, in one line: where, what is wrong, how to mend it.

    file, line, column: the place in a scene file; line is 0 where there is none, and file may then
    name a setting or a call. code: "input" where the user can mend it, "machine" where the machine
    lacks something.
    """

    def __init__(self, message, file="", line=0, column=0, code="input"):
        super().__init__(message)
        self.file = file
        self.line = line
        self.column = column
        self.code = code
