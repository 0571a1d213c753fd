package frustum.model.demos.voxel

/** What a player of a voxel world holds down. */
final case class VoxelButtons(
    forward: Boolean = false,
    back: Boolean = false,
    left: Boolean = false,
    right: Boolean = false,
    up: Boolean = false,
    down: Boolean = false,
    turnLeft: Boolean = false,
    turnRight: Boolean = false,
    lookUp: Boolean = false,
    lookDown: Boolean = false,
    next: Boolean = false,
    previous: Boolean = false,
    place: Boolean = false,
    destroy: Boolean = false
)
