"""An independent numeric oracle of the seed's robot, in plain numpy."""
