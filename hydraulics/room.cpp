// filled by the branch of this room
