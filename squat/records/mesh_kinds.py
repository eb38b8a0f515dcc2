"""The kind of dataset that holds a mesh."""

from squat.records.schema import Kind, Variable

_NODE, _FACE, _CORNER = ("node",), ("face",), ("corner",)
_LIMITS = "lengths at rest that bound the hull's motion; fraction (of clearance): a pure number"
MESH = Kind(
    "mesh",
    1,
    "Mesh around a hull in a channel, and the submesh that moves it",
    {
        "topology": Variable((), "1", "UGRID 1.0 topology of the mesh"),
        "node_x": Variable(_NODE, "m", "distance of the node from the bow towards the stern"),
        "node_z": Variable(_NODE, "m", "height of the node above the bottom's level"),
        "face_node": Variable(("face", "three"), "1", "nodes of the triangle, counterclockwise"),
        "face_zone": Variable(_FACE, "1", "coarse triangle that the triangle lies in"),
        "face_quality": Variable(_FACE, "1", "4 sqrt(3) area over the sum of squared sides"),
        "face_angle": Variable(_FACE, "degree", "smallest angle of the triangle"),
        "edge_node": Variable(("edge", "two"), "1", "ends of the boundary edge, water on the left"),
        "edge_boundary": Variable(("edge",), "1", "boundary that the edge belongs to"),
        "boundary": Variable(("boundary",), "1", "names of the boundaries (Fig. 3)"),
        "moved_x": Variable(_NODE, "m", "node_x at the shown position"),
        "moved_z": Variable(_NODE, "m", "node_z at the shown position"),
        "moved_quality": Variable(_FACE, "1", "face_quality at the shown position"),
        "moved_surge": Variable((), "m", "surge of the shown position"),
        "moved_heave": Variable((), "m", "heave of the shown position, positive up"),
        "moved_pitch": Variable((), "rad", "pitch of the shown position, positive bow down"),
        "order": Variable((), "1", "polynomial order meant for the triangles"),
        "corner_x": Variable(_CORNER, "m", "x of the coarse vertex"),
        "corner_z": Variable(_CORNER, "m", "z of the coarse vertex"),
        "corner_role": Variable(
            _CORNER, "1", "0 fixed, 1 rigid with the hull, 2 water line at the hull, 3 follower"
        ),
        "corner_partner": Variable(_CORNER, "1", "hull point that roles 2 and 3 follow"),
        "corner_slope": Variable(_CORNER, "1", "slope dz/dx of a follower's path"),
        "zone_corner": Variable(("zone", "three"), "1", "coarse vertices of the zone"),
        "hull_corner": Variable(("hull_point",), "1", "coarse vertices that are hull points"),
        "keel_corner": Variable(("keel_point",), "1", "those of them nearest to the bottom"),
        "bed_x": Variable(("bed_point",), "m", "x of the bottom's points"),
        "bed_z": Variable(("bed_point",), "m", "z of the bottom's points"),
        "moved_corner_x": Variable(_CORNER, "m", "corner_x at the shown position"),
        "moved_corner_z": Variable(_CORNER, "m", "corner_z at the shown position"),
        "center": Variable(("axis",), "m", "point that pitch turns about, at rest"),
        "axis": Variable(("axis",), "1", "names of the coordinates"),
        "limits": Variable(("limit",), "m", _LIMITS),
        "limit": Variable(("limit",), "1", "names of those lengths, and fraction"),
    },
)
