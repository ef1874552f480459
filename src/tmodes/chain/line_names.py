"""Names of elastic lines: that of a node, with a number after it where its link has several, one after another."""

from __future__ import annotations

from collections.abc import Sequence

from tmodes.chain.chain import Chain, Node

__all__ = ["line_before", "node_of_line"]


def node_of_line(chain: Chain, name: str) -> Node | None:
    """The node whose link has a line of this name; None for a line that a system draws between its points."""
    nodes = {node.name: node for node in chain.nodes}
    return nodes[name] if name in nodes else nodes.get(name.rpartition(".")[0])


def line_before(chain: Chain, name: str, lines: Sequence[str]) -> str | None:
    """The one of ``lines`` on which a line stands, the nearest towards the base; None for the base."""
    node = node_of_line(chain, name)
    own = [line for line in lines if node_of_line(chain, line) is node]
    if node is not None and name in own and own.index(name):
        return own[own.index(name) - 1]
    while node is not None and node.parent >= 0:
        node = chain.nodes[node.parent]
        if own := [line for line in lines if node_of_line(chain, line) is node]:
            return own[-1]
    return None
