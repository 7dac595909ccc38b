/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/automatic_pairs.h"

#include <algorithm>
#include <cctype>
#include <functional>

#include "base/errors.h"
#include "mesh/mixed_cells.h"
#include "parameters/formula.h"

namespace Contact
{
  namespace
  {
    /// A face that bounds a body, its corners one after the other.
    struct OuterFace
    {
      std::string       body;
      std::vector<long> nodes;
    };

    /// By corners in ascending order.
    using OuterFaces = std::map<std::vector<long>, OuterFace>;



    std::vector<long> sorted(std::vector<long> nodes)
    {
      std::sort(nodes.begin(), nodes.end());
      return nodes;
    }



    std::vector<std::vector<unsigned int>>
    corners_of_faces(const unsigned int dim, const unsigned int n_corners)
    {
      if (dim == 3)
        return faces_of_volume(n_corners);
      std::vector<std::vector<unsigned int>> edges;
      for (unsigned int i = 0; i < n_corners; ++i)
        edges.push_back({i, (i + 1) % n_corners});
      return edges;
    }



    OuterFaces outer_faces(const MshFile &msh)
    {
      OuterFaces                  faces;
      std::set<std::vector<long>> inner;
      for (const auto &cell : msh.elements[msh.dimension()])
        for (const auto &corners :
             corners_of_faces(msh.dimension(), cell.nodes.size()))
          {
            OuterFace face{cell.groups.empty() ? "" : *cell.groups.begin(), {}};
            for (const unsigned int corner : corners)
              face.nodes.push_back(cell.nodes[corner]);
            const auto key = sorted(face.nodes);
            if (!faces.emplace(key, face).second)
              inner.insert(key);
          }
      for (const auto &key : inner)
        faces.erase(key);
      return faces;
    }



    std::string surface_of(const std::string &body)
    {
      return body + " surface";
    }



    /// The outer faces of a body: their nodes, and how large they are.
    struct BodySurface
    {
      std::set<long> nodes;
      double         edges   = 0; // lengths of all sides of the faces [mm]
      unsigned int   n_edges = 0;

      double mean_edge() const
      {
        return edges / n_edges;
      }
    };

    std::map<std::string, BodySurface> surfaces_of(const MshFile    &msh,
                                                   const OuterFaces &faces)
    {
      std::map<std::string, BodySurface> surfaces;
      for (const auto &[key, face] : faces)
        {
          BodySurface &surface = surfaces[face.body];
          surface.nodes.insert(key.begin(), key.end());
          for (unsigned int i = 0; i < face.nodes.size(); ++i)
            {
              const long a = face.nodes[i],
                         b = face.nodes[(i + 1) % face.nodes.size()];
              surface.edges += msh.nodes.at(a).distance(msh.nodes.at(b));
              ++surface.n_edges;
            }
        }
      return surfaces;
    }



    bool share_nodes(const BodySurface &a, const BodySurface &b)
    {
      return std::any_of(a.nodes.begin(), a.nodes.end(), [&](const long node) {
        return b.nodes.count(node) > 0;
      });
    }



    using TwoBodies = std::pair<std::string, std::string>;

    TwoBodies in_order(const std::string &a, const std::string &b)
    {
      return {std::min(a, b), std::max(a, b)};
    }



    /// The bodies that named pairs are about.
    std::set<TwoBodies> paired_by_name(const Parameters::All &parameters,
                                       const MshFile         &msh,
                                       const OuterFaces      &faces)
    {
      std::map<std::string, std::set<std::string>> bodies; // by group
      for (const auto &element : msh.elements[msh.dimension() - 1])
        if (const auto face = faces.find(sorted(element.nodes));
            face != faces.end())
          for (const std::string &group : element.groups)
            bodies[group].insert(face->second.body);
      std::set<TwoBodies> found;
      for (const auto &pair : parameters.pairs())
        for (const std::string &a : bodies[pair.slave])
          for (const std::string &b : bodies[pair.master])
            found.insert(in_order(a, b));
      return found;
    }



    /// A name that a section can have.
    std::string name_of_pair(std::string name)
    {
      for (char &c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' &&
            c != '-')
          c = ' ';
      return name;
    }



    /// Whether a face belongs to a new group.
    using IsIn = std::function<bool(const OuterFace &)>;

    /// Add groups of outer faces; of each name there must be none.
    void add_groups(MshFile                           &msh,
                    const OuterFaces                  &faces,
                    const std::map<std::string, IsIn> &groups,
                    const std::string                 &remedy)
    {
      auto &elements = msh.elements[msh.dimension() - 1];
      std::map<std::vector<long>, std::size_t> known;
      for (std::size_t i = 0; i < elements.size(); ++i)
        known[sorted(elements[i].nodes)] = i;
      std::set<std::string> names;
      for (const auto &element : elements)
        names.insert(element.groups.begin(), element.groups.end());

      for (const auto &[name, is_in] : groups)
        {
          if (names.count(name) > 0)
            throw InputError("there is a group '" + name + "' already",
                             msh.name,
                             remedy);
          for (const auto &[key, face] : faces)
            if (is_in(face))
              {
                if (const auto found = known.find(key); found != known.end())
                  elements[found->second].groups.insert(name);
                else
                  {
                    known[key] = elements.size();
                    elements.push_back({0, face.nodes, {name}});
                  }
              }
        }
    }



    /// Give each body the group of its outer faces.
    void name_outer_surfaces(MshFile &msh)
    {
      const auto                  faces = outer_faces(msh);
      std::map<std::string, IsIn> groups;
      for (const auto &[key, face] : faces)
        groups[surface_of(face.body)] = [body = face.body](const auto &other) {
          return other.body == body;
        };
      add_groups(msh,
                 faces,
                 groups,
                 "rename it: with 'Surfaces = automatic' that is the name of "
                 "all faces of a body");
    }



    /// Name outer faces by a condition of their corners. Throws InputError if
    /// there is none.
    void name_by_place(MshFile                                  &msh,
                       const std::map<std::string, std::string> &boundaries)
    {
      if (boundaries.empty())
        return;
      const std::string entry = "Mesh/Faces", in = " in ";
      const auto        faces = outer_faces(msh);
      for (const auto &[name, condition] : boundaries)
        {
          const auto        at = name.find(in);
          const std::string body =
            at == std::string::npos ? "" : name.substr(at + in.size());
          const auto meets = parse_formula<3>(condition, "x,y,z", entry);
          const IsIn is_in = [&](const OuterFace &face) {
            return (body.empty() || face.body == body) &&
                   std::all_of(face.nodes.begin(),
                               face.nodes.end(),
                               [&](const long node) {
                                 return meets(msh.nodes.at(node)) > 0;
                               });
          };
          if (std::none_of(faces.begin(), faces.end(), [&](const auto &face) {
                return is_in(face.second);
              }))
            throw InputError("no outer face" +
                               (body.empty() ? "" : " of '" + body + "'") +
                               " has all of its corners where '" + condition +
                               "'",
                             "entry '" + entry + "', '" + name + "'",
                             "leave room for round-off, as in 'y > 9.99' or "
                             "'abs(x) < 0.01'; coordinates are those of the "
                             "file");
          add_groups(msh, faces, {{name.substr(0, at), is_in}}, "rename it");
        }
    }



    /// The surfaces of the bodies that a section names.
    std::map<std::string, BodySurface>
    among(const Parameters::Contact                &section,
          const std::map<std::string, BodySurface> &surfaces)
    {
      if (section.bodies.empty())
        return surfaces;
      std::map<std::string, BodySurface> found;
      for (const std::string &body : section.bodies)
        if (const auto surface = surfaces.find(body); surface != surfaces.end())
          found.insert(*surface);
        else
          throw InputError("there is no body '" + body + "'",
                           "entry '" + section.section() + "/Bodies'",
                           "name bodies of the mesh");
      return found;
    }



    /// The section, or null.
    const Parameters::Contact *
    automatic_section(const Parameters::All &parameters)
    {
      if (parameters.contact.is_automatic())
        return &parameters.contact;
      for (const auto &further : parameters.further_contacts)
        if (further.second.is_automatic())
          return &further.second;
      return nullptr;
    }
  } // namespace



  MshFile read_with_surfaces(const Parameters::Mesh &parameters)
  {
    MshFile msh = read_msh(parameters.file);
    name_by_place(msh, parameters.faces);
    if (parameters.has_outer_surfaces)
      name_outer_surfaces(msh);
    return msh;
  }



  void add_automatic_pairs(Parameters::All &parameters)
  {
    const Parameters::Contact *section = automatic_section(parameters);
    if (section == nullptr)
      return;
    if (parameters.solids.symmetry == Parameters::Symmetry::axisymmetric)
      throw InputError("the axis would be a surface of rings",
                       "entry '" + section->section() + "/Surfaces'",
                       "name slave and master");
    const MshFile    msh      = read_with_surfaces(parameters.mesh);
    const OuterFaces faces    = outer_faces(msh);
    const auto       surfaces = among(*section, surfaces_of(msh, faces));
    const auto       named    = paired_by_name(parameters, msh, faces);
    const auto       modulus  = [&](const std::string &body) {
      const auto found = parameters.solids.youngs_modulus.find(body);
      return found == parameters.solids.youngs_modulus.end() ? 0
                                                                    : found->second;
    };
    const auto is_better_slave = [&](const auto &a, const auto &b) {
      return std::make_pair(modulus(a.first), a.second.mean_edge()) <
             std::make_pair(modulus(b.first), b.second.mean_edge());
    };

    std::vector<Parameters::Contact> pairs;
    const auto add = [&](const std::string &slave, const std::string &master) {
      if (named.count(in_order(slave, master)) > 0)
        return;
      pairs.push_back(*section);
      pairs.back().surfaces = Parameters::ContactSurfaces::named;
      pairs.back().bodies.clear();
      pairs.back().is_made = true;
      pairs.back().name    = name_of_pair(slave + " " + master);
      pairs.back().slave   = surface_of(slave);
      pairs.back().master  = surface_of(master);
    };
    for (auto a = surfaces.begin(); a != surfaces.end(); ++a)
      {
        if (section->surfaces == Parameters::ContactSurfaces::with_self_contact)
          add(a->first, a->first);
        for (auto b = std::next(a); b != surfaces.end(); ++b)
          if (share_nodes(a->second, b->second))
            continue;
          else if (is_better_slave(*b, *a))
            add(b->first, a->first);
          else
            add(a->first, b->first);
      }
    if (pairs.empty())
      throw InputError("there are no two bodies that could touch",
                       "entry '" + section->section() + "/Surfaces'",
                       "name the surfaces: bodies that share nodes, and those "
                       "of other pairs, have no automatic pair");
    for (const Parameters::Contact &pair : pairs)
      if (!parameters.further_contacts.emplace(pair.name, pair).second)
        throw InputError("two contact pairs have the name '" + pair.name + "'",
                         pair.section(),
                         "rename a body, or the section");
    parameters.mesh.has_outer_surfaces = true;
    parameters.check();
  }
} // namespace Contact
