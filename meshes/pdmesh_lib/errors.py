"""What a user of pdmesh did wrong."""


class MeshError(Exception):
    """Message names the file or option, what is wrong and, where there is one, the remedy."""
