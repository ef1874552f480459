"""The local web application: a server on this machine, workers that simulate, and a page whose forms are the schema."""
