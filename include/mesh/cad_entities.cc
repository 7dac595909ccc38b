/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/cad_entities.h"

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <gmsh.h>
#include <limits>

namespace Contact
{
  namespace CadEntities
  {
    std::string label_of(const int dim, const int tag)
    {
      std::string name;
      gmsh::model::getEntityName(dim, tag, name);
      name = name.substr(name.rfind('/') + 1);
      if (name.find("Open CASCADE ") == 0)
        return "";
      for (char &c : name)
        if (c == ':' || c == ',' || c == ';' || c == '"')
          c = '_';
      return Utilities::trim(name);
    }



    std::vector<int> tags_of(const int dim)
    {
      gmsh::vectorpair entities;
      gmsh::model::getEntities(entities, dim);
      std::vector<int> tags;
      for (const auto &entity : entities)
        tags.push_back(entity.second);
      return tags;
    }



    std::pair<std::vector<int>, std::vector<int>> adjacent(const int dim,
                                                           const int tag)
    {
      std::pair<std::vector<int>, std::vector<int>> tags;
      gmsh::model::getAdjacencies(dim, tag, tags.first, tags.second);
      return tags;
    }



    double content(const int dim, const int tag)
    {
      double content;
      gmsh::model::occ::getMass(dim, tag, content);
      return content;
    }



    void add_group(const int               dim,
                   const std::vector<int> &tags,
                   const std::string      &name)
    {
      const int group = gmsh::model::addPhysicalGroup(dim, tags);
      gmsh::model::setPhysicalName(dim, group, name);
    }



    double diagonal(const int dim, const int tag)
    {
      Point<3> a, b;
      gmsh::model::getBoundingBox(dim, tag, a[0], a[1], a[2], b[0], b[1], b[2]);
      return a.distance(b);
    }



    namespace
    {
      Point<3> to_point(const std::vector<double> &X)
      {
        return {X[0], X[1], X[2]};
      }



      /// Whether a place on what a surface was cut out of is on the surface:
      /// gmsh finds no coordinates of others, or some of another place.
      bool is_inside(const int tag, const std::vector<double> &X)
      {
        const double        digits = 1e-6 * diagonal(2, tag);
        std::vector<double> coordinates, found;
        gmsh::model::getParametrization(2, tag, X, coordinates);
        gmsh::model::getValue(2, tag, coordinates, found);
        return to_point(X).distance(to_point(found)) < digits &&
               gmsh::model::isInside(2, tag, coordinates) > 0;
      }
    } // namespace



    Point<3> closest_place(const int dim, const int tag, const Point<3> &X)
    {
      std::vector<double> Y, coordinates;
      if (dim == 0)
        gmsh::model::getValue(0, tag, {}, Y);
      else
        gmsh::model::getClosestPoint(dim,
                                     tag,
                                     {X[0], X[1], X[2]},
                                     Y,
                                     coordinates);
      if (dim < 2 || is_inside(tag, Y))
        return to_point(Y);
      Point<3> closest;
      double   distance = std::numeric_limits<double>::max();
      for (const int part : adjacent(dim, tag).second)
        if (const auto other = closest_place(dim - 1, part, X);
            other.distance(X) < distance)
          {
            closest  = other;
            distance = other.distance(X);
          }
      return closest;
    }



    double radius(const int dim, const int tag)
    {
      std::vector<double> lowest, highest, places, curvatures;
      gmsh::model::getParametrizationBounds(dim, tag, lowest, highest);
      for (const double part : {0.25, 0.5, 0.75})
        for (int d = 0; d < dim; ++d)
          places.push_back(lowest[d] + part * (highest[d] - lowest[d]));
      gmsh::model::getCurvature(dim, tag, places, curvatures);
      return 1 / *std::max_element(curvatures.begin(), curvatures.end());
    }



    std::map<std::string, std::vector<int>> find_groups(const int dim)
    {
      std::map<std::string, std::vector<int>> groups;
      gmsh::vectorpair                        all;
      gmsh::model::getPhysicalGroups(all, dim);
      for (const auto &group : all)
        {
          std::string name;
          gmsh::model::getPhysicalName(dim, group.second, name);
          gmsh::model::getEntitiesForPhysicalGroup(dim,
                                                   group.second,
                                                   groups[name]);
        }
      return groups;
    }
  } // namespace CadEntities
} // namespace Contact
