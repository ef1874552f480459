"""Cases of a batch on an NVIDIA GPU, one case per thread: the loops of single runs as PTX, and what runs them."""
