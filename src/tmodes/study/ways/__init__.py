"""Ways to compute the cases of a study: reduced in the native loop, at rest, or by whole results; one file each."""
