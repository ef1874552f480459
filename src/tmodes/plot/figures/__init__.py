"""One file for each figure of tmodes."""
