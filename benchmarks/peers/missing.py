"""A peer that is not installed here is left out of the table with its reason; it never stops the benchmark."""

from __future__ import annotations


class PeerMissing(RuntimeError):
    """This peer cannot run on this machine; the message says what to install."""
