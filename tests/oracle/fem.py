"""A small finite element code, plane strain and axisymmetric, degree 1 and 2;
blocks of elements (blocks.py, law_block.py) also in 3-D (space_fem.py)."""
# SPDX-License-Identifier: LGPL-2.1-or-later
import warnings

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spl

import elements
import law_block
import materials
from blocks import Block


class Model:
    """The bodies of a scene: mesh of its degree, stiffness, loads, supports."""

    def __init__(self, scene):
        self.scene = scene
        self.degree = scene.degree
        self.axisymmetric = scene.axisymmetric
        self.large = scene.large
        mesh = scene.mesh
        self.n_vertices = len(mesh.X)
        self.X = mesh.X
        self.dim = mesh.X.shape[1]
        self.middle = {}
        cells = mesh.cells
        if self.degree == 2:
            cells = self.add_middles(mesh, cells)
        # Degrees of freedom that follow others: in 3-D.
        self.bound = np.zeros(self.X.shape, bool)
        self.lines = {name: self.complete(lines)
                      for name, lines in mesh.lines.items()}
        self.blocks = [self.block(body, kind, array)
                       for (body, kind), array in cells.items()]
        self.cells = cells
        self.body_of = np.zeros(len(self.X), int)
        for (body, _), array in cells.items():
            self.body_of[array.ravel()] = mesh.bodies.index(body)
        self.loads = self.make_loads()

    def block(self, body, kind, cells):
        scene = self.scene
        law, thermal = scene.laws.get(body), scene.thermal.get(body)
        if law is None and thermal is None:
            return Block(self, kind, cells, *materials.lame(
                *scene.material(body)), scene.is_large(body))
        law = law or materials.Elastic(*scene.material(body))
        return law_block.LawBlock(self, kind, cells, law, scene.is_large(body),
                                  thermal)

    @property
    def has_history(self):
        return any(block.has_history for block in self.blocks)

    def at(self, t):
        """Heat the bodies as they are at the time t."""
        for block in self.blocks:
            block.at(t)

    def reset(self):
        """Forget all increments."""
        for block in self.blocks:
            block.reset()

    def advance(self, u):
        """An increment has ended with these displacements."""
        for block in self.blocks:
            block.advance(u)

    def add_middles(self, mesh, cells):
        X = list(map(tuple, mesh.X))
        arcs = {tuple(sorted(line)): arc for name, arc in mesh.arcs.items()
                for line in mesh.lines[name]}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in self.middle:
                p = (mesh.X[a] + mesh.X[b]) / 2
                if key in arcs:
                    x, y, radius = arcs[key]
                    d = p - (x, y)
                    p = (x, y) + d * abs(radius) / np.hypot(*d)
                self.middle[key] = len(X)
                X.append(tuple(p))
            return self.middle[key]
        complete = {}
        for key, array in cells.items():
            n = array.shape[1]
            complete[key] = np.array(
                [list(c) + [middle(c[i], c[(i + 1) % n]) for i in range(n)]
                 for c in array.tolist()])
        self.X = np.array(X)
        return complete

    def complete(self, lines):
        if self.degree == 1:
            return np.array(lines)
        return np.array([[a, b, self.middle[min(a, b), max(a, b)]]
                         for a, b in lines])

    def following(self, u):
        """The displacements; those that follow others in their places."""
        return u

    def nodes_of(self, name):
        """The nodes of a boundary or point group."""
        if name in self.lines:
            return np.unique(self.lines[name])
        return np.array([self.scene.mesh.points[name]])

    def in_groups(self, names):
        """Which nodes are in any of these groups."""
        found = np.zeros(len(self.X), bool)
        for name in names:
            found[self.nodes_of(name)] = True
        return found

    def forces(self, u):
        total = np.zeros_like(self.X)
        for block in self.blocks:
            np.add.at(total, block.cells, block.forces(u))
        return total

    def magnitude(self, u, error):
        """How far the force on each node is off if each displacement is off by
        `error` (by node)."""
        total = np.zeros(self.X.size)
        for block in self.blocks:
            K = np.abs(block.tangent(u))
            e = np.repeat(error[block.cells], self.dim, axis=1)
            np.add.at(total, block.dofs, np.einsum("eij,ej->ei", K, e))
        return total.reshape(self.X.shape)

    def tangent(self, u):
        rows, columns, values = [], [], []
        for block in self.blocks:
            K = block.tangent(u)
            n = K.shape[1]
            rows.append(np.repeat(block.dofs, n, axis=1).ravel())
            columns.append(np.tile(block.dofs, (1, n)).ravel())
            values.append(K.ravel())
        size = self.X.size
        return sp.csc_matrix((np.concatenate(values), (np.concatenate(
            rows), np.concatenate(columns))), shape=(size, size))

    # Loads: by entry, for the factor one.
    def make_loads(self):
        loads = {}
        rigid = self.scene.rigid
        for entry, items in self.scene.boundary.items():
            if entry.split()[0] in ("Displacement", "Rigid", "Rotation",
                                    "Moment"):
                continue
            total = loads.setdefault(entry, np.zeros_like(self.X))
            for name, value in items.items():
                if not (name in rigid and entry.startswith("Force")):
                    total += self.load(entry, name, value)
        return loads

    def load(self, entry, name, value):
        direction = np.array([entry.endswith(d) for d in "xyz"[:self.dim]],
                             float)
        if entry.startswith("Body force"):
            return self.body_force(name, value, direction)
        if entry.startswith("Force"):
            total = np.zeros_like(self.X)
            total[self.nodes_of(name)[0]] = value * direction
            return total
        if entry == "Pressure":
            return self.edge_load(name, lambda X, n: -scalar(value, X) * n)
        if entry.startswith("Traction"):
            return self.edge_load(name, lambda X, n: scalar(value, X) *
                                  direction)
        unit = self.edge_load(name, lambda X, n: direction)
        return unit * value / unit.sum()

    def edge_load(self, name, traction):
        total = np.zeros_like(self.X)
        for line in self.lines[name]:
            for x, w in zip(*np.polynomial.legendre.leggauss(self.degree + 1)):
                N, slope = elements.edge(x, self.degree)
                X, t = N @ self.X[line], slope @ self.X[line]
                # The body is on the left.
                length = np.hypot(*t)
                normal = np.array([t[1], -t[0]]) / length
                around = 2 * np.pi * X[0] if self.axisymmetric else 1
                total[line] += np.outer(N, w * length * around *
                                        traction(X, normal))
        return total

    def body_force(self, name, value, direction):
        total = np.zeros_like(self.X)
        for (body, kind), cells in self.cells.items():
            if body != name:
                continue
            shape, points = elements.rule(kind, self.degree)
            if kind == "triangle":
                points = elements.hammer_seven()
            elif kind == "tet":
                points = elements.collapsed(3, 3)
            for p, w in points:
                N, slope = shape(*p)
                X = np.einsum("a,eai->ei", N, self.X[cells])
                J = np.linalg.det(np.einsum("eai,aj->eij", self.X[cells],
                                            slope))
                f = w * J * (2 * np.pi * X[:, 0] if self.axisymmetric else 1)
                np.add.at(total, cells, value * np.einsum(
                    "e,a,i->eai", f, N, direction))
        return total

    def external(self, t):
        total = np.zeros_like(self.X)
        for entry, load in self.loads.items():
            total += self.scene.factor(entry, t) * load
        return total

    def load_scale(self, t):
        """The sum of the loads without regard to their signs."""
        return sum(abs(self.scene.factor(entry, t)) * np.abs(load).sum()
                   for entry, load in self.loads.items())

    def supports(self, t):
        """Whether a degree of freedom is prescribed, and the value."""
        held = np.zeros(self.X.shape, bool)
        value = np.zeros_like(self.X)
        for d in range(self.dim):
            entry = "Displacement " + "xyz"[d]
            for name, u in self.scene.boundary.get(entry, {}).items():
                if name in self.scene.rigid:
                    continue
                nodes = self.nodes_of(name)
                held[nodes, d] = True
                value[nodes, d] = u * self.scene.factor(entry, t)
        if self.axisymmetric:
            held[np.abs(self.X[:, 0]) < 1e-10 * np.abs(self.X).max(), 0] = True
        return held, value

    def solve(self, t=1.0, steps=1, fixed=None, u=None):
        """The displacements without contact, by Newton's method; `fixed`: more
        degrees of freedom that stay as they are in u."""
        u = np.zeros_like(self.X) if u is None else u.copy()
        for k in range(1, steps + 1):
            held, value = self.supports(t * k / steps)
            if fixed is not None:
                held = held | fixed
                value = np.where(fixed, u, value)
            free = ~(held | self.bound).ravel()
            self.at(t * k / steps)
            for _ in range(60):
                # The first step moves the supports, on the tangent of before.
                change = np.where(held, value - u, 0).ravel()
                K = self.tangent(u)
                r = (self.external(t * k / steps) - self.forces(u)).ravel() - (
                    K @ change)
                with warnings.catch_warnings():
                    # A singular matrix gives no numbers, see below.
                    warnings.simplefilter("ignore", spl.MatrixRankWarning)
                    du = spl.spsolve(K[free][:, free].tocsc(), r[free])
                change[free] = du
                u = self.following(u + change.reshape(u.shape))
                if not np.isfinite(du).all():
                    raise ArithmeticError("the reference does not converge")
                if np.abs(du).max(initial=0) <= 1e-12 * np.abs(u).max():
                    break
            else:
                raise ArithmeticError("the reference does not converge")
        return u


def scalar(value, X):
    return value(*X) if callable(value) else value
