#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""One run of the benchmark with GetFEM, reported as one line of JSON.

    getfem_driver.py MESH [--contact raytracing|integral|nodal]
                     [--small] [--friction MU] [--increments N] ...

MESH is a .npz file of mesh.py; its cells have 4 or 8 nodes. The contact
conditions are augmented Lagrangians with multipliers on the slave surface:

- raytracing: large sliding, gap and normal of the deformed surfaces;
- integral, nodal: small sliding, gap and normal of the undeformed surfaces, in
  Gauss points or in nodes, without friction.

The load is spread over Cap. The cylinder is held by contact alone: Newton's
method starts with it pressed into the block by --start mm, so that some points
touch. Its own report of convergence is not enough: a step counts only if the
block transmits the load to its support within --balance. A step that fails is
cut in half.

SIYY(B) is the Cauchy stress in the cell at B: the least-squares fit of bilinear
functions to the values in the quadrature points, evaluated at B.
"""

import argparse
import json
import resource
import time

START = time.perf_counter()

import getfem  # noqa: E402
import numpy as np  # noqa: E402

import mesh as meshes  # noqa: E402

AXE, ENCAST, CONTACT, CAP = 1, 2, 3, 4
# Young's modulus and Poisson's ratio.
MATERIAL = {"Block": (70000., .3), "Cylinder": (210000., .3)}
LOAD = -17500.
REFERENCE_NODES = ((0, 0), (1, 0), (1, 1), (0, 1),
                   (.5, 0), (1, .5), (.5, 1), (0, .5))
TRANSFORMATION = {4: "GT_QK(2,1)", 8: "GT_Q2_INCOMPLETE(2)"}
ELEMENT = {4: "FEM_QK(2,1)", 8: "FEM_Q2_INCOMPLETE(2)"}
# Gauss points of n x n: exact to this degree.
QUADRATURE = {4: 3, 8: 5}


def options_of_call():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("mesh")
    parser.add_argument("--contact", default="raytracing",
                        choices=("raytracing", "integral", "nodal"))
    parser.add_argument("--small", action="store_true", help="small strain")
    parser.add_argument("--friction", type=float, default=0.)
    parser.add_argument("--increments", type=int, default=1)
    parser.add_argument("--cuts", type=int, default=4,
                        help="how often a step may be cut in half")
    parser.add_argument("--steps", type=int, default=30,
                        help="Newton steps before giving up")
    parser.add_argument("--tolerance", type=float, default=1e-8,
                        help="residual by load")
    parser.add_argument("--balance", type=float, default=1e-2)
    parser.add_argument("--start", type=float, default=.05)
    parser.add_argument("--augmentation", type=float, default=70000.)
    parser.add_argument("--release", type=float, default=5.)
    parser.add_argument("--version", type=int, default=0,
                        help="of the brick (raytracing)")
    parser.add_argument("--multiplier-degree", type=int, default=1,
                        choices=(1, 2), help="as the demos of GetFEM: 1")
    parser.add_argument("--points", type=int, default=5,
                        help="Gauss points on an edge of the slave")
    parser.add_argument("--line-search", default="simplest")
    parser.add_argument("--noisy", action="store_true")
    options = parser.parse_args()
    if options.friction > 0 and options.contact != "raytracing":
        parser.error("friction is for --contact raytracing")
    return options


class Body:
    """A mesh of GetFEM with its boundaries; bodies share no nodes."""

    def __init__(self, mesh, name, boundaries):
        cells = mesh.cells[name]
        self.n = cells.shape[1]
        transformation = getfem.GeoTrans(TRANSFORMATION[self.n])
        order = [int(np.argmin([np.hypot(*(p - q)) for q in REFERENCE_NODES]))
                 for p in np.asarray(transformation.pts()).T]
        self.mesh = getfem.Mesh("empty", 2)
        self.mesh.add_convex(transformation,
                             mesh.nodes[cells[:, order]].transpose(2, 1, 0))

        faces = {}
        for convex, face in np.asarray(self.mesh.outer_faces())[:2].T:
            points = self.mesh.pid_in_faces([[convex], [face]])
            middle = self.mesh.pts(np.ravel(points)).mean(axis=1)
            faces[tuple(np.round(middle, 6) + 0.)] = (convex, face)
        for number, group in boundaries.items():
            middles = mesh.nodes[mesh.edges[group]].mean(axis=1)
            found = [faces.get(tuple(np.round(m, 6) + 0.)) for m in middles]
            self.mesh.set_region(
                number, np.array([f for f in found if f is not None]).T)
        self.integration = self.rule(QUADRATURE[self.n])

    def rule(self, degree):
        return getfem.MeshIm(self.mesh, getfem.Integ(
            f"IM_GAUSS_PARALLELEPIPED(2,{degree})"))

    def space(self, components, element=""):
        space = getfem.MeshFem(self.mesh, components)
        space.set_fem(getfem.Fem(element or ELEMENT[self.n]))
        return space


def dofs_at(space, point):
    nodes = space.basic_dof_nodes()
    return np.flatnonzero(np.hypot(nodes[0] - point[0],
                                   nodes[1] - point[1]) < 1e-7)


def stress_formula(body, u, small):
    """The stress of the weak form, and the Cauchy stress."""
    young, poisson = MATERIAL[body]
    first = young * poisson / ((1 + poisson) * (1 - 2 * poisson))
    second = young / (2 * (1 + poisson))
    if small:
        stress = (f"({first!r}*Trace(Grad_{u})*Id(2)+"
                  f"{2 * second!r}*Sym(Grad_{u}))")
        return stress, stress
    f = f"(Id(2)+Grad_{u})"
    e = f"(0.5*({f}'*{f}-Id(2)))"
    nominal = f"({f}*({first!r}*Trace({e})*Id(2)+{2 * second!r}*{e}))"
    return nominal, f"({nominal}*{f}'/Det({f}))"


class Model:
    """The scene, its state and its solution by load increments."""

    def __init__(self, options):
        self.options = options
        mesh = meshes.load(options.mesh)
        self.top = Body(mesh, "Cylinder",
                        {AXE: "Axe", CONTACT: "Bottom_C", CAP: "Cap"})
        self.block = Body(mesh, "Block",
                          {AXE: "Axe", ENCAST: "Encast", CONTACT: "Top_B"})
        self.bodies = (("Cylinder", "u1", self.top),
                       ("Block", "u2", self.block))
        self.corner = mesh.nodes[mesh.points["B"][0]]
        self.model = getfem.Model("real")
        for name, u, body in self.bodies:
            self.model.add_fem_variable(u, body.space(2))
            self.add_elasticity(name, u, body)
            self.model.add_normal_Dirichlet_condition_with_multipliers(
                body.integration, u, body.space(1), AXE)
        self.model.add_Dirichlet_condition_with_simplification("u2", ENCAST)
        length = getfem.asm("generic", self.top.integration, 0, "1", CAP)
        self.traction = LOAD / float(np.ravel(length)[0])
        self.model.add_initialized_data("traction", [0., 0.])
        self.model.add_source_term_brick(self.top.integration, "u1",
                                         "traction", CAP)
        self.add_contact()
        start = np.zeros(self.model.variable("u1").size)
        start[1::2] = -options.start
        self.model.set_variable("u1", start)

    def add_elasticity(self, name, u, body):
        young, poisson = MATERIAL[name]
        parameters = [young * poisson / ((1 + poisson) * (1 - 2 * poisson)),
                      young / (2 * (1 + poisson))]
        if self.options.small:
            for letter, value in zip("lm", parameters):
                self.model.add_initialized_data(letter + u, [value])
            self.model.add_isotropic_linearized_elasticity_brick(
                body.integration, u, "l" + u, "m" + u)
        else:
            self.model.add_initialized_data("c" + u, parameters)
            self.model.add_finite_strain_elasticity_brick(
                body.integration, "SaintVenant Kirchhoff", u, "c" + u)

    def add_contact(self):
        model, options = self.model, self.options
        model.add_initialized_data("r", [options.augmentation])
        model.add_initialized_data("friction", [options.friction])
        model.add_initialized_data("alpha", [1.])
        for _, u, body in self.bodies:
            model.add_fem_data("old_" + u, body.space(2))
        # Kept: GetFEM does not, once Python forgets it.
        self.rule = rule = self.top.rule(2 * options.points - 1)
        if options.contact == "nodal":
            # The brick makes its multipliers.
            model.add_nodal_contact_between_nonmatching_meshes_brick(
                self.top.integration, self.block.integration, "u1", "u2",
                "lambda", "r", CONTACT, CONTACT)
            return
        vector = options.contact == "raytracing"
        element = ELEMENT[4 * options.multiplier_degree]
        model.add_filtered_fem_variable(
            "lambda", self.top.space(2 if vector else 1, element), CONTACT)
        if options.contact == "raytracing":
            brick = model.add_integral_large_sliding_contact_brick_raytracing(
                "r", options.release, "friction", "alpha", options.version)
            model.add_slave_contact_boundary_to_large_sliding_contact_brick(
                brick, rule, CONTACT, "u1", "lambda", "old_u1")
            model.add_master_contact_boundary_to_large_sliding_contact_brick(
                brick, self.block.integration, CONTACT, "u2", "old_u2")
        else:
            model.add_integral_contact_between_nonmatching_meshes_brick(
                rule, "u1", "u2", "lambda", "r",
                CONTACT, CONTACT, 1)

    def transmitted(self):
        """The force that the block exerts on its support, upwards."""
        nominal, _ = stress_formula("Block", "u2", self.options.small)
        forces = getfem.asm("generic", self.block.integration, 1,
                            f"{nominal}:Grad_Test_u2", -1, self.model)
        size = self.model.variable("u2").size
        place = self.model.interval_of_variable("u2")[0]
        forces = np.ravel(forces)[place:place + size]
        nodes = self.block.space(2).basic_dof_nodes()
        support = np.flatnonzero(abs(nodes[1] + 200) < 1e-7)
        return float(forces[support[support % 2 == 1]].sum())

    def step(self, factor):
        """Newton's method at a load factor: steps, '' or what went wrong."""
        options = self.options
        self.model.set_variable("traction", [0., self.traction * factor])
        words = ["max_iter", options.steps, "max_res",
                 options.tolerance, "lsolver", "mumps", "lsearch",
                 options.line_search] + ["noisy"] * options.noisy
        try:
            steps, converged = self.model.solve(*words)
        except RuntimeError as error:
            return 0, str(error).strip().splitlines()[-1][:100]
        if not converged:
            return int(steps), f"no convergence in {steps} Newton steps"
        error = self.transmitted() / (-LOAD * factor) - 1
        if not abs(error) < options.balance:
            return int(steps), ("said to be converged, but transmits "
                                f"{100 * (1 + error):.1f} % of the load")
        return int(steps), ""

    def state(self):
        return {name: np.array(self.model.variable(name))
                for name in ("u1", "u2", "lambda")}

    def restore(self, state):
        for name, values in state.items():
            self.model.set_variable(name, values)

    def solve(self):
        """The path to the full load, and how it went."""
        size, factor = 1 / self.options.increments, 0.
        smallest = size / 2**self.options.cuts
        result = {"newton": 0, "increments": 0, "cuts": 0, "reason": ""}
        saved = self.state()
        while factor < 1 - 1e-9:
            steps, reason = self.step(min(1., factor + size))
            result["newton"] += steps
            if not reason:
                factor = min(1., factor + size)
                result["increments"] += 1
                saved = self.state()
                self.model.set_variable("old_u1", saved["u1"])
                self.model.set_variable("old_u2", saved["u2"])
                continue
            result["cuts"] += 1
            self.restore(saved)
            size /= 2
            if size < smallest * (1 - 1e-9):
                result["reason"] = f"load factor {factor:.3g}: {reason}"
                break
        return result

    def probes(self):
        _, cauchy = stress_formula("Block", "u2", self.options.small)
        space = self.block.space(1, "FEM_QK_DISCONTINUOUS(2,1)")
        stress = self.model.local_projection(self.block.integration,
                                             f"{cauchy}(2,2)", space)
        u = self.model.variable("u2")
        return {
            "DY(B)": float(u[dofs_at(self.block.space(2), self.corner)[1]]),
            "SIYY(B)": float(np.mean(stress[dofs_at(space, self.corner)])),
            "force_error": self.transmitted() / -LOAD - 1}


def main():
    options = options_of_call()
    getfem.util_trace_level(0)
    getfem.util_warning_level(0)
    model = Model(options)
    result = {"unknowns": int(model.model.nbdof()), **model.solve()}
    result["ok"] = not result["reason"]
    if result["ok"]:
        result.update(model.probes())
    usage = resource.getrusage(resource.RUSAGE_SELF)
    result.update(wall=time.perf_counter() - START,
                  cpu=usage.ru_utime + usage.ru_stime,
                  memory=usage.ru_maxrss / 1024)
    print(json.dumps(result), flush=True)


if __name__ == "__main__":
    main()
