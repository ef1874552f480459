"""The data sheet of the robot of Filipovic & Djuric (2010): its format, and the robot that it gives."""
