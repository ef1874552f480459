"""The peers of the speed benchmark: other ways to run the same robot over the same 2 s. No code of the package."""
