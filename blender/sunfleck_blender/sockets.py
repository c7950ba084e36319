"""Finds sockets of nodes by the names of Blender 3.x and 4.x, and what is linked to them."""

# Our name: (names of the socket, newest last). 4.x is untested.
NAMES = {
    "base colour": ("Base Color",),
    "metallic": ("Metallic",),
    "roughness": ("Roughness",),
    "ior": ("IOR",),
    "alpha": ("Alpha",),
    "normal": ("Normal",),
    "specular": ("Specular", "Specular IOR Level"),
    "transmission": ("Transmission", "Transmission Weight"),
    "clearcoat": ("Clearcoat", "Coat Weight"),
    "clearcoat roughness": ("Clearcoat Roughness", "Coat Roughness"),
    "sheen": ("Sheen", "Sheen Weight"),
    "subsurface": ("Subsurface", "Subsurface Weight"),
    "anisotropic": ("Anisotropic", "Anisotropy"),
    "rotation": ("Anisotropic Rotation", "Rotation"),
    "emission": ("Emission", "Emission Color"),
    "emission strength": ("Emission Strength",),
    "colour": ("Color",),
    "strength": ("Strength",),
    "density": ("Density",),
    "factor": ("Fac", "Factor"),
}


def socket(node, name):
    """Returns the input that one of the names of `name` calls, or None."""
    for known in NAMES.get(name, (name,)):
        found = node.inputs.get(known)
        if found is not None:
            return found
    return None


def enabled(node, *names):
    """Returns the first enabled input of one of these names, or None: MIX nodes have many."""
    return next((s for s in node.inputs if s.name in names and s.enabled), None)


def is_colour(found):
    """Returns whether a socket holds a colour or a vector, not one number."""
    return found.type in ("RGBA", "VECTOR")


def source(found, groups=()):
    """Returns (node, output, groups) that is linked to an input, or None.

    Goes through reroutes, muted nodes and groups; groups are the group nodes around the input.
    """
    for _ in range(1000):
        if not found.is_linked or not found.links:
            return None
        link = found.links[0]
        node, output = link.from_node, link.from_socket
        if getattr(link, "is_muted", False):
            return None
        if node.type == "REROUTE":
            found = node.inputs[0]
        elif node.mute:
            inside = next((l for l in node.internal_links if l.to_socket == output), None)
            if inside is None:
                return None
            found = inside.from_socket
        elif node.type == "GROUP" and node.node_tree:
            end = next((n for n in node.node_tree.nodes
                        if n.type == "GROUP_OUTPUT" and n.is_active_output), None)
            inner = end and next((s for s in end.inputs if s.identifier == output.identifier), None)
            if inner is None:
                return None
            if not inner.is_linked:
                return Unlinked(inner), inner, groups
            found, groups = inner, groups + (node,)
        elif node.type == "GROUP_INPUT" and groups:
            outer = next((s for s in groups[-1].inputs if s.identifier == output.identifier), None)
            if outer is None:
                return None
            groups = groups[:-1]
            if not outer.is_linked:
                return Unlinked(outer), outer, groups
            found = outer
        else:
            return node, output, groups
    return None


class Unlinked:
    """Stands for a group's socket that nothing is linked to: it has a value of its own."""
    type = "UNLINKED"
    name = "a group's socket"

    def __init__(self, own):
        self.socket = own
