"""Batches on a GPU: the same works as on the processor, one case per thread."""
