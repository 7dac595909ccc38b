/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/cad_model.h"

#include <deal.II/base/numbers.h>

#include <Interface_Static.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <algorithm>
#include <cmath>
#include <gmsh.h>
#include <limits>

#include "base/errors.h"
#include "base/string_utilities.h"
#include "mesh/cad_entities.h"
#include "mesh/groups.h"

namespace Contact
{
  using namespace dealii;
  using namespace CadEntities;

  namespace
  {
    const std::string boundaries_entry = "entry 'Mesh/Boundaries'";
    const std::string mend =
      "mend the geometry (surfaces that cross each other, gaps between them), "
      "or choose another Mesh/Size";
  } // namespace



  CadModel::Session::Session()
  {
    gmsh::initialize(0, nullptr, /*readConfigFiles=*/false);
    gmsh::option::setNumber("General.Terminal", 0);
    // An exception would leave a loop of several threads, and end the program.
    gmsh::option::setNumber("General.AbortOnError", 1);
    // OpenCASCADE reads labels of faces if it is asked to.
    STEPCAFControl_Controller::Init();
    Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1);
  }



  CadModel::Session::~Session()
  {
    gmsh::finalize();
  }



  CadModel::CadModel(const std::string           &file,
                     const Parameters::Geometry  &parameters,
                     const std::set<std::string> &in_contact)
    : file(file)
    , parameters(parameters)
    , is_geo(Parameters::Geometry::source_of(file) ==
             Parameters::Geometry::Source::geo)
  {
    call([&]() { gmsh::open(file); },
         "gmsh cannot read the file",
         is_geo ? "correct the file; 'gmsh FILE' shows what it draws"
                : "export the part anew, as STEP (AP214 or AP242)");
    call(
      [&]() {
        name_bodies();
        name_boundaries();
        choose_sizes(in_contact);
      },
      "gmsh cannot measure the geometry",
      mend);
  }



  std::string CadModel::version()
  {
    return GMSH_API_VERSION;
  }



  /// Whatever gmsh complains of, by exceptions of any type or in its log alone;
  /// complaints behind the first one follow from that.
  void CadModel::call(const std::function<void()> &work,
                      const std::string           &what,
                      const std::string           &remedy) const
  {
    bool has_failed = false;
    gmsh::logger::start();
    try
      {
        work();
      }
    catch (const InputError &)
      {
        throw;
      }
    catch (...)
      {
        has_failed = true;
      }
    std::vector<std::string> log;
    gmsh::logger::get(log);
    gmsh::logger::stop();
    // Places beside a surface have no coordinates on it, as they should.
    const std::string beside = "Inverse surface mapping";
    for (const std::string &line : log)
      if (line.find("Error: ") == 0 && line.find(beside) == std::string::npos)
        throw InputError(what + ": " + line.substr(7), file, remedy);
    if (has_failed)
      throw InputError(what, file, remedy);
  }



  void CadModel::name_bodies()
  {
    dim = gmsh::model::getDimension();
    if (dim < 2)
      throw InputError("the file has no volumes and no surfaces",
                       file,
                       "export solids (in the plane: faces), as STEP");
    bodies     = find_groups(dim);
    has_groups = !bodies.empty();
    if (has_groups)
      return;
    for (const int tag : tags_of(dim))
      bodies[label_of(dim, tag)].push_back(tag);

    // Volumes that are equal but for round-off: in the order of the file.
    const auto order = [&](const int tag) {
      const double digits = 1e6;
      return -std::llround(digits * std::log(content(dim, tag)));
    };
    if (auto &numbered = bodies[""]; numbered.size() > 1)
      std::stable_sort(numbered.begin(),
                       numbered.end(),
                       [&](const int a, const int b) {
                         return order(a) < order(b);
                       });
    // Numbers go past names that other parts have.
    for (const auto &[label, tags] : bodies)
      {
        unsigned int number = 0;
        for (const int tag : tags)
          {
            std::string name = label;
            if (label.empty() || tags.size() > 1)
              do
                name = (label.empty() ? "Body" : label) + " " +
                       std::to_string(++number);
              while (bodies.count(name) > 0);
            add_group(dim, {tag}, name);
          }
      }
    parts.swap(bodies);
    bodies = find_groups(dim);
  }



  /// By labels and by points. Faces without a label of their own have that of
  /// their part. Of a part that an assembly has several times gmsh knows the
  /// labels of the faces of one: the faces of all are in the same order.
  void CadModel::name_boundaries()
  {
    Groups     labelled;
    const auto label_boundary = [&](const int tag, const int as) {
      const auto label = label_of(dim - 1, as);
      if (!label.empty() && parts.count(label) == 0)
        labelled[label].push_back(tag);
      return !label.empty() && parts.count(label) == 0;
    };
    std::set<int> known;
    for (const int tag : tags_of(dim - 1))
      if (!has_groups && label_boundary(tag, tag))
        known.insert(tag);
    for (const auto &[part, tags] : parts)
      {
        std::vector<int> labels; // of one, in the order of its faces
        for (const int tag : tags)
          if (const auto faces = adjacent(dim, tag).second;
              !part.empty() &&
              std::any_of(faces.begin(), faces.end(), [&](const int face) {
                return known.count(face) > 0;
              }))
            labels = faces;
        for (const int tag : tags)
          if (const auto faces = adjacent(dim, tag).second;
              faces.size() == labels.size())
            for (unsigned int i = 0; i < faces.size(); ++i)
              if (known.count(faces[i]) == 0)
                label_boundary(faces[i], labels[i]);
      }
    for (const auto &[label, tags] : labelled)
      add_group(dim - 1, tags, label);
    for (const auto &[name, numbers] : parameters.boundaries)
      name_boundary(name, numbers);
    boundaries = find_groups(dim - 1);
  }



  /// A boundary of 'name' or 'name in body', of all parts on which one of the
  /// points lies.
  void CadModel::name_boundary(const std::string         &key,
                               const std::vector<double> &numbers) const
  {
    const std::string in       = " in ";
    const auto        position = key.rfind(in);
    const std::string name     = key.substr(0, position);
    if (find_groups(dim - 1).count(name) > 0)
      throw InputError("the file has a boundary '" + name + "' of its own",
                       boundaries_entry,
                       "choose another name");
    if (numbers.empty() || numbers.size() % dim != 0)
      throw InputError("the boundary '" + name + "' has no points",
                       boundaries_entry,
                       dim == 3 ? "write 'x, y, z' of each, in mm"
                                : "write 'x, y' of each, in mm");
    Groups among = bodies;
    if (position != std::string::npos)
      {
        const std::string body = key.substr(position + in.size());
        among = {{body, find_group(bodies, "body", body, "Mesh/Boundaries")}};
      }
    std::set<int> tags;
    for (auto X = numbers.begin(); X != numbers.end(); X += dim)
      tags.insert(boundary_at({X[0], X[1], dim == 3 ? X[2] : 0}, name, among));
    add_group(dim - 1, {tags.begin(), tags.end()}, name);
  }



  /// The part of the boundary on which a point lies, up to the digits of what
  /// is typed.
  int CadModel::boundary_at(const Point<3>    &X,
                            const std::string &name,
                            const Groups      &among) const
  {
    const double  typed = 1e-4 * diagonal();
    std::set<int> found;
    Point<3>      closest;
    std::string   of;
    for (const auto &[body, tags] : among)
      for (const int tag : tags)
        for (const int side : adjacent(dim, tag).second)
          {
            const Point<3> place = closest_place(dim - 1, side, X);
            if (place.distance(X) <= typed)
              found.insert(side);
            if (of.empty() || place.distance(X) < closest.distance(X))
              {
                closest = place;
                of      = body;
              }
          }
    const std::string lies =
      "the point (" + brief(X) + ") mm of '" + name + "' lies on ";
    if (found.empty())
      throw InputError(lies + "no boundary",
                       boundaries_entry,
                       "the nearest one, of '" + of + "', is " +
                         brief(closest.distance(X)) + " mm away, at (" +
                         brief(closest) + ") mm");
    if (found.size() > 1)
      throw InputError(lies + std::to_string(found.size()) + " boundaries",
                       boundaries_entry,
                       "choose a point inside of one; where bodies touch, "
                       "name the body: '" +
                         name + " in BODY: x, y, z'");
    return *found.begin();
  }



  void CadModel::limit(const Entity &entity, const double size)
  {
    const auto [known, is_new] = sizes.emplace(entity, size);
    if (!is_new)
      known->second = std::min(known->second, size);
  }



  void CadModel::choose_sizes(const std::set<std::string> &in_contact)
  {
    const double on_contact      = 0.5;
    const double cells_of_a_turn = 12;
    Groups       all             = boundaries;
    all.insert(bodies.begin(), bodies.end());
    for (const auto &own : parameters.sizes)
      find_group(all, "body and no boundary", own.first, "Mesh/Sizes");

    std::set<int> of_contact;
    for (const std::string &name : in_contact)
      if (boundaries.count(name) > 0)
        of_contact.insert(boundaries[name].begin(), boundaries[name].end());
    for (const auto &[name, tags] : bodies)
      for (const int tag : tags)
        {
          const auto sides = adjacent(dim, tag).second;
          double     size  = parameters.size;
          if (parameters.sizes.count(name) > 0)
            size = parameters.sizes.at(name);
          else if (size == 0 && is_geo)
            continue;
          else if (size == 0)
            {
              double boundary = 0;
              for (const int side : sides)
                boundary += content(dim - 1, side);
              size = content(dim, tag) / boundary;
            }
          set_size({dim, tag}, size);
          for (const int side : sides)
            {
              const double round =
                is_geo
                  ? size
                  : 2 * numbers::PI * radius(dim - 1, side) / cells_of_a_turn;
              limit({dim - 1, side},
                    std::min(size, round) *
                      (of_contact.count(side) > 0 ? on_contact : 1));
            }
        }
    for (const auto &[name, size] : parameters.sizes)
      if (boundaries.count(name) > 0)
        for (const int tag : boundaries[name])
          set_size({dim - 1, tag}, size);

    // Curves and points have the smallest size of what they bound.
    for (int d = dim - 2; d >= 0; --d)
      for (const int tag : tags_of(d))
        for (const int above : adjacent(d, tag).first)
          if (sizes.count({d + 1, above}) > 0)
            limit({d, tag}, sizes[{d + 1, above}]);
  }



  /// A slip of the decimal point would fill the memory.
  void CadModel::set_size(const Entity &entity, const double size)
  {
    const double most    = 1e8;
    const double n_cells = is_geo ? 0
                                  : content(entity.first, entity.second) /
                                      std::pow(size, entity.first);
    if (!(size > 0))
      throw InputError("a body has no volume: its boundary is open or crosses "
                       "itself",
                       file,
                       mend);
    if (n_cells > most)
      throw InputError("cells of " + brief(size) + " mm: there would be " +
                         brief(n_cells) + " of them",
                       "entries 'Mesh/Size' and 'Mesh/Sizes'",
                       "choose larger ones");
    sizes[entity] = size;
  }



  std::string CadModel::describe() const
  {
    std::string text = sizes.empty() ? "" : "sizes in mm: ";
    const auto  add  = [&](const Groups &groups, const int dimension) {
      for (const auto &[name, tags] : groups)
        {
          const auto size = sizes.find({dimension, tags.at(0)});
          text += name + (size == sizes.end() ? "" : " " + brief(size->second));
          Point<3> centre;
          if (dimension == dim && !is_geo)
            {
              gmsh::model::occ::getCenterOfMass(dim,
                                                tags[0],
                                                centre[0],
                                                centre[1],
                                                centre[2]);
              for (unsigned int d = 0; d < 3; ++d)
                if (std::abs(centre[d]) < 1e-6 * diagonal()) // round-off
                  centre[d] = 0;
              text += " (about " + brief(centre) + ")";
            }
          text += ", ";
        }
    };
    add(bodies, dim);
    add(boundaries, dim - 1);
    return text.substr(0, text.size() - 2);
  }



  void CadModel::write_mesh(const std::string &msh_file)
  {
    // A tenth of the diagonal is the largest size that gmsh takes, times its
    // factor. Where each body has a size, that of points is none.
    double factor = 1;
    if (!is_geo || parameters.size > 0)
      {
        for (const auto &of_entity : sizes)
          factor = std::max(factor, 10 * of_entity.second / diagonal());
        gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
        gmsh::option::setNumber("Mesh.MeshSizeFactor", factor);
      }
    // Later versions hand on the size that follows from all else.
    gmsh::model::mesh::setSizeCallback(
      [&](int d, int tag, double, double, double, auto... others) {
        const auto   found = sizes.find({d, tag});
        const double size  = found == sizes.end()
                               ? std::numeric_limits<double>::max()
                               : found->second / factor;
        return std::min({size, static_cast<double>(others)...});
      });
    if (!is_geo && dim == 2) // quadrangles alone, refined one by one
      {
        gmsh::option::setNumber("Mesh.RecombineAll", 1);
        gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 3);
      }
    if (!is_geo)
      gmsh::option::setNumber("Mesh.HighOrderOptimize", 1);
    if (parameters.order > 0 || !is_geo)
      gmsh::option::setNumber("Mesh.ElementOrder",
                              parameters.order == 1 ? 1 : 2);
    gmsh::option::setNumber("Mesh.Binary", 0);
    call([&]() { gmsh::model::mesh::generate(dim); },
         "gmsh cannot mesh the bodies",
         mend);
    call([&]() { gmsh::write(msh_file); },
         "gmsh cannot write the mesh",
         "set Output/Directory to a place where you may write");
  }
} // namespace Contact
