/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "mesh/msh_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/string_utilities.h"
#include "mesh/mid_sides.h"
#include "mesh/mixed_cells.h"


namespace Contact
{
  namespace
  {
    /// The properties of an element type of gmsh.
    struct ElementType
    {
      unsigned int dimension, n_nodes, n_corners;
    };

    const std::map<int, ElementType> element_types = {{15, {0, 1, 1}},
                                                      {1, {1, 2, 2}},
                                                      {8, {1, 3, 2}},
                                                      {2, {2, 3, 3}},
                                                      {9, {2, 6, 3}},
                                                      {3, {2, 4, 4}},
                                                      {16, {2, 8, 4}},
                                                      {10, {2, 9, 4}},
                                                      {4, {3, 4, 4}},
                                                      {11, {3, 10, 4}},
                                                      {7, {3, 5, 5}},
                                                      {19, {3, 13, 5}},
                                                      {14, {3, 14, 5}},
                                                      {6, {3, 6, 6}},
                                                      {18, {3, 15, 6}},
                                                      {13, {3, 18, 6}},
                                                      {5, {3, 8, 8}},
                                                      {17, {3, 20, 8}},
                                                      {12, {3, 27, 8}}};

    /// Fills an MshFile, section by section.
    class MshReader
    {
    public:
      explicit MshReader(const std::string &file)
        : lines(file)
      {
        msh.name = file;
      }

      MshFile read();

    private:
      std::string read_format();
      void        read_names();
      void        read_entities();
      void        read_nodes_22();
      void        read_nodes_41();
      void        read_elements_22();
      void        read_elements_41();

      ElementType read_type();
      Point<3>    read_point();
      void        read_node(const long number);
      void        read_element(const ElementType      &type,
                               const long              number,
                               const std::vector<int> &tags);
      void        check_nodes() const;
      void        check_groups() const;

      LineReader lines;
      MshFile    msh;

      /// Dimension and tag of a gmsh entity -> tags of its physical groups.
      std::map<std::pair<int, int>, std::vector<int>> entities;

      /// By dimension: sorted nodes of an element -> where it stands.
      std::array<std::map<std::vector<long>, std::size_t>, 4> known;

      /// Nodes that are no corner of an element -> the element's number.
      std::map<long, long> middle_nodes;
    };



    ElementType MshReader::read_type()
    {
      const int  number = lines.read<int>("the type of an element");
      const auto type   = element_types.find(number);
      if (type == element_types.end())
        lines.fail("gmsh elements of type " + std::to_string(number) +
                     " are not supported",
                   "mesh a surface (gmsh -2) with lines, triangles and "
                   "quadrangles of first or second order, or a volume (gmsh "
                   "-3) with tetrahedra, hexahedra, wedges and pyramids");
      return type->second;
    }



    Point<3> MshReader::read_point()
    {
      Point<3> p;
      for (unsigned int d = 0; d < 3; ++d)
        {
          p[d] = lines.read<double>("a coordinate");
          // Products of four lengths still have to be numbers.
          if (!(std::abs(p[d]) < 1e60))
            lines.fail("a coordinate is not below 1e60",
                       "the file is damaged: write it again");
        }
      return p;
    }



    /// The coordinates of a node; parametric ones may follow: not needed.
    void MshReader::read_node(const long number)
    {
      if (!msh.nodes.emplace(number, read_point()).second)
        lines.fail("node " + std::to_string(number) + " is defined twice",
                   "write the file again");
    }



    /// The nodes of an element, which close its line.
    void MshReader::read_element(const ElementType      &type,
                                 const long              number,
                                 const std::vector<int> &tags)
    {
      std::vector<long> nodes(type.n_nodes);
      for (long &node : nodes)
        node = lines.read<long>("the number of a node");

      // gmsh lists the corners first.
      for (unsigned int i = type.n_corners; i < type.n_nodes; ++i)
        middle_nodes.emplace(nodes[i], number);
      add_mid_sides(type.dimension, type.n_corners, nodes, msh.mid_sides);
      nodes.resize(type.n_corners);
      auto sorted = nodes;
      std::sort(sorted.begin(), sorted.end());

      auto &elements = msh.elements[type.dimension];
      const auto [position, is_new] =
        known[type.dimension].emplace(sorted, elements.size());
      if (is_new)
        elements.push_back({number, nodes, {}});

      auto       &element = elements[position->second];
      const auto &names   = msh.names[type.dimension];
      for (const int tag : tags)
        if (names.count(tag) > 0 &&
            !element.groups.insert(names.at(tag)).second && !is_new)
          lines.fail("element " + std::to_string(number) +
                       " of the physical group '" + names.at(tag) +
                       "' has the corners of element " +
                       std::to_string(element.number),
                     "an element stands once in each of its groups: delete "
                     "one of the two, or mesh without overlaps");
    }



    /// Returns the version, which decides how the other sections are read.
    std::string MshReader::read_format()
    {
      const std::string remedy =
        "convert it: gmsh <file> -save -format msh41 -o <new file> (or msh22)";

      if (!lines.next() ||
          lines.read<std::string>("$MeshFormat") != "$MeshFormat")
        lines.fail("the mesh file is empty or not in gmsh's MSH format",
                   remedy);

      lines.next_in("$MeshFormat");
      const auto version = lines.read<std::string>("the version of the format");
      if (version != "2.2" && version != "4.1")
        lines.fail("MSH format " + LineReader::legible(version) +
                     " is not supported, only 2.2 and 4.1 are",
                   remedy);
      if (lines.read<int>("0 (ASCII) or 1 (binary)") != 0)
        lines.fail("the mesh file is binary, only ASCII is supported",
                   remedy + ", without the option -bin");
      lines.end("$MeshFormat");
      return version;
    }



    void MshReader::read_names()
    {
      const long n_names = lines.count("$PhysicalNames");
      for (long i = 0; i < n_names; ++i)
        {
          lines.next_in("$PhysicalNames");
          const auto dimension = lines.read<unsigned int>("a dimension");
          const int  tag       = lines.read_tag();
          const auto name      = lines.read_quoted();
          if (dimension >= msh.names.size() || name.empty())
            lines.fail("expected the dimension 0, 1, 2 or 3, a tag and a name",
                       "a mesh has physical points, curves, surfaces and "
                       "volumes");
          for (const auto &group : msh.names[dimension])
            if (group.first == tag || group.second == name)
              lines.fail("two physical groups of dimension " +
                           std::to_string(dimension) + " share the name '" +
                           LineReader::legible(name) + "' or the tag " +
                           std::to_string(tag),
                         "give every physical group a name of its own");
          msh.names[dimension][tag] = name;
        }
    }



    void MshReader::read_entities()
    {
      lines.next_in("$Entities");
      std::array<long, 4> n_entities;
      for (long &n : n_entities)
        n = lines.read<long>("the number of entities");

      for (int dimension = 0; dimension < 4; ++dimension)
        for (long i = 0; i < n_entities[dimension]; ++i)
          {
            lines.next_in("$Entities");
            const auto tag = lines.read<int>("the tag of an entity");
            // The point itself, or the two corners of a bounding box.
            for (unsigned int p = 0; p < (dimension == 0 ? 1 : 2); ++p)
              read_point();
            const auto n_groups = lines.read<long>("the number of groups");
            for (long g = 0; g < n_groups; ++g)
              entities[{dimension, tag}].push_back(lines.read_tag());
          }
    }



    void MshReader::read_nodes_22()
    {
      const long n_nodes = lines.count("$Nodes");
      for (long i = 0; i < n_nodes; ++i)
        {
          lines.next_in("$Nodes");
          read_node(lines.read<long>("the number of a node"));
        }
    }



    void MshReader::read_nodes_41()
    {
      const long n_blocks = lines.count("$Nodes");
      for (long block = 0; block < n_blocks; ++block)
        {
          lines.next_in("$Nodes");
          lines.read<int>("the dimension of an entity");
          lines.read<int>("the tag of an entity");
          lines.read<int>("0 or 1 (parametric coordinates)");
          const auto n_nodes = lines.read<long>("the number of nodes");

          // First all numbers, then all coordinates.
          std::vector<long> numbers;
          for (long i = 0; i < n_nodes; ++i)
            {
              lines.next_in("$Nodes");
              numbers.push_back(lines.read<long>("the number of a node"));
            }
          for (const long number : numbers)
            {
              lines.next_in("$Nodes");
              read_node(number);
            }
        }
    }



    void MshReader::read_elements_22()
    {
      const long n_elements = lines.count("$Elements");
      for (long i = 0; i < n_elements; ++i)
        {
          lines.next_in("$Elements");
          const auto number = lines.read<long>("the number of an element");
          const auto type   = read_type();

          // The first tag is the physical group, 0 for none; what follows are
          // the entity and partitions.
          const auto       n_tags = lines.read<long>("the number of tags");
          std::vector<int> tags;
          for (long t = 0; t < n_tags; ++t)
            tags.push_back(lines.read_tag());
          tags.resize(std::min<std::size_t>(tags.size(), 1));
          read_element(type, number, tags);
        }
    }



    void MshReader::read_elements_41()
    {
      const long n_blocks = lines.count("$Elements");
      for (long block = 0; block < n_blocks; ++block)
        {
          lines.next_in("$Elements");
          const auto dimension  = lines.read<int>("the dimension of an entity");
          const auto tag        = lines.read<int>("the tag of an entity");
          const auto type       = read_type();
          const auto n_elements = lines.read<long>("the number of elements");
          for (long i = 0; i < n_elements; ++i)
            {
              lines.next_in("$Elements");
              const auto number = lines.read<long>("the number of an element");
              read_element(type, number, entities[{dimension, tag}]);
            }
        }
    }



    /// Every node in use exists, those of plane cells lie in a plane, and
    /// hexahedra are bounded by quadrangles.
    void MshReader::check_nodes() const
    {
      const auto check = [&](const long node, const long number) {
        if (msh.nodes.count(node) == 0)
          throw InputError("node " + std::to_string(node) + " does not exist",
                           msh.name + ", element " + std::to_string(number),
                           "write the file again");
      };
      for (const auto &elements : msh.elements)
        for (const auto &element : elements)
          for (const long node : element.nodes)
            check(node, element.number);
      for (const auto &[node, number] : middle_nodes)
        check(node, number);

      if (msh.dimension() == 3)
        {
          for (const auto &face : msh.elements[2])
            if (face.nodes.size() != 4 && !msh.has_simplices())
              throw InputError("a triangle is no face of a hexahedron",
                               msh.where(face),
                               "recombine the surfaces that bound volumes");
          return;
        }
      for (const auto &cell : msh.elements[2])
        for (const long node : cell.nodes)
          {
            const long     first = msh.elements[2][0].nodes[0];
            const Point<3> p = msh.nodes.at(node), q = msh.nodes.at(first);
            if (std::abs(p[2] - q[2]) > 1e-9 * p.distance(q))
              throw InputError("the mesh is not plane: node " +
                                 std::to_string(node) + " is " +
                                 brief(p[2] - q[2]) + " mm above node " +
                                 std::to_string(first),
                               msh.where(cell),
                               "of bodies in 3-D name the volumes, Physical "
                               "Volume(\"...\") = {...}, and mesh with gmsh "
                               "-3; plane ones lie in a plane of constant z");
          }
    }



    /// There is a body, and no named group is empty, which would be a slip in
    /// the description of the geometry.
    void MshReader::check_groups() const
    {
      if (msh.names[msh.dimension()].empty())
        {
          const bool        is_plane = msh.dimension() == 2;
          const std::string kind     = is_plane ? "Surface" : "Volume";
          throw InputError(std::string("the mesh has no physical ") +
                             (is_plane ? "surface" : "volume") + " with a name",
                           msh.name,
                           "name the bodies in the .geo file: Physical " +
                             kind + "(\"...\") = {...};");
        }

      for (unsigned int dimension = 0; dimension < msh.names.size();
           ++dimension)
        {
          std::set<std::string> unused;
          for (const auto &group : msh.names[dimension])
            unused.insert(group.second);
          for (const auto &element : msh.elements[dimension])
            for (const std::string &group : element.groups)
              unused.erase(group);
          if (!unused.empty())
            throw InputError("the physical group '" + *unused.begin() +
                               "' is empty",
                             msh.name,
                             "give it elements or delete it; bodies share no "
                             "nodes: no Coherence, no fragments");
        }
    }



    MshFile MshReader::read()
    {
      const std::string version = read_format();
      while (lines.next())
        {
          const auto section = lines.read<std::string>("a section");
          if (section == "$PhysicalNames")
            read_names();
          else if (section == "$Entities" && version == "4.1")
            read_entities();
          else if (section == "$PartitionedEntities")
            lines.fail("the mesh is partitioned",
                       "mesh it without gmsh's option -part");
          else if (section == "$Nodes")
            version == "2.2" ? read_nodes_22() : read_nodes_41();
          else if (section == "$Elements")
            version == "2.2" ? read_elements_22() : read_elements_41();
          else
            {
              lines.skip(section);
              continue;
            }
          lines.end(section);
        }
      check_nodes();
      check_groups();
      return msh;
    }
  } // namespace



  MshFile read_msh(const std::string &file)
  {
    MshFile msh = MshReader(file).read();
    split_mixed_cells(msh);
    return msh;
  }
} // namespace Contact
