# SPDX-License-Identifier: LGPL-2.1-or-later
"""Output requests as probes; without any, the forces of supports and contact."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .deck import Block
from .parts import Scope

if TYPE_CHECKING:
    from .case import Case

# Abaqus' names of what nodes have: all components, or one of them.
QUANTITIES = {"U": "displacement", "RF": "support"}


def take_node_output(case: Case, block: Block, scope: Scope) -> None:
    """*NODE PRINT, *NODE OUTPUT and *NODE FILE of a set."""
    name = block.options.get("NSET", "")
    left = []
    for row in block.rows:
        for field in row.fields:
            word, number = field.upper().rstrip("123"), field[-1:]
            components = range(1, case.deck.dimension + 1) \
                if field.upper() == word else [int(number)]
            if word not in QUANTITIES or not name:
                left.append(field)
                continue
            nodes = case.deck.numbers(scope, "node", name, row)
            group = group_of(case, name, nodes, block, scope, word)
            for c in components if group else ():
                if c <= case.deck.dimension:
                    ask(case, f"{QUANTITIES[word]} {'xyz'[c - 1]}", group)
    if left:
        case.leave(block, ", ".join(left) + ": see the sections Output and Probes")


def group_of(case: Case, name: str, nodes: list[int], block: Block, scope: Scope,
             word: str) -> str:
    """The point of one node; for forces the boundary that all nodes are."""
    found = case.deck.find(scope, "node", name, block)
    title = case.deck.title(found.scope, found.name)
    if word == "RF":
        return title  # is looked for among the supports, which come later
    if len(nodes) == 1 and nodes[0] in case.groups.corners:
        return case.groups.point(title, nodes[0])
    case.leave(block, f"displacements of the set '{name}', which is not one corner "
               "of elements: name a point in Mesh/Points")
    return ""


def ask(case: Case, quantity: str, group: str) -> None:
    groups = case.wanted.setdefault(quantity, [])
    if group not in groups:
        groups.append(group)


def put_probes(case: Case) -> None:
    supports = {(load.entry[-1], load.group): load for load in case.loads.values()
                if load.entry.startswith("Displacement")}
    asks_for_forces = any(q.startswith("support") for q in case.wanted)
    for quantity, sets in case.wanted.items():
        for name in sets:
            groups, _ = case.groups.supported.get(name, ([name], []))
            for group in groups:
                if not quantity.startswith("support") or \
                        (quantity[-1], group) in supports:
                    put(case, quantity, group)
    for direction, group in () if asks_for_forces else supports:
        put(case, f"support {direction}", group)
    for section in [s for s in case.entries if s.startswith("Contact")]:
        if "Slave" not in case.entries[section]:
            continue
        slave = case.entries[section]["Slave"][0]
        nodes = {n for facet in case.groups.facets.values()
                 if slave in facet.groups for n in facet.nodes}
        for direction in "xyz"[:case.deck.dimension]:
            if not nodes <= case.held.get(direction, set()):
                put(case, f"contact force {direction}", slave)


def put(case: Case, quantity: str, group: str) -> None:
    probe = f"{quantity} {group}: {quantity}, {group}"
    if probe not in case.entries.get("Probes", {}).get("Probes", ()):
        case.put("Probes", "Probes", probe)


KEYWORDS = dict.fromkeys(("NODEPRINT", "NODEOUTPUT", "NODEFILE"),
                         take_node_output)
