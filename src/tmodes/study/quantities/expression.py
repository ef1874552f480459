"""A formula of parameters and other quantities."""
