"""What a user touches: Robot, Result, and a function for each command, whose answer prints itself."""
