/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "msh_file.h"

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <utility>

#include "errors.h"

namespace Contact
{
  namespace
  {
    /**
     * The lines of a file, one after the other, and the numbers of a line.
     * Knows where it is, so that every complaint can say so. Blank lines are
     * passed over.
     */
    class LineReader
    {
    public:
      explicit LineReader(const std::string &file)
        : file(file)
        , input(file)
      {
        if (!input)
          throw InputError("the mesh file can not be opened",
                           file,
                           "check the name and the permissions of the file; a "
                           "relative name is relative to the parameter file");
      }

      /// Go to the next line; false at the end of the file.
      bool next()
      {
        std::string line;
        while (std::getline(input, line))
          {
            ++number;
            words.clear();
            words.str(line);
            if (!(words >> std::ws).eof())
              return true;
          }
        return false;
      }

      /// Go to the next line, which has to exist: we are inside a section.
      void next_in(const std::string &section)
      {
        if (!next())
          fail("the mesh file ends inside " + section,
               "the file is incomplete: write it again");
      }

      /// The next value of the line.
      template<typename T>
      T read(const std::string &meaning)
      {
        T value;
        if (!(words >> value))
          fail("expected " + meaning + " in '" + words.str() + "'",
               "the file is damaged or incomplete: write it again");
        return value;
      }

      /// The name of a physical group, which stands in quotes.
      std::string read_quoted()
      {
        std::string name;
        words >> std::quoted(name);
        return name;
      }

      /// The sign of a tag is an orientation, which we do not need.
      int read_tag()
      {
        return std::abs(read<int>("the tag of a group"));
      }

      /// The last line of a section.
      void end(const std::string &section)
      {
        const std::string keyword = "$End" + section.substr(1);
        next_in(section);
        if (const auto found = read<std::string>(keyword); found != keyword)
          fail("expected " + keyword + ", found '" + found + "'",
               "the section announces another number of entries than it has: "
               "write the file again");
      }

      /// Pass over the lines of a section which is not needed.
      void skip(const std::string &section)
      {
        do
          next_in(section);
        while (words.str().find("$End" + section.substr(1)) != 0);
      }

      [[noreturn]] void fail(const std::string &what,
                             const std::string &remedy) const
      {
        throw InputError(what, file + ":" + std::to_string(number), remedy);
      }

    private:
      const std::string  file;
      std::ifstream      input;
      std::istringstream words;
      unsigned int       number = 0;
    };



    /// Dimension and tag of a gmsh entity -> tags of its physical groups.
    using Entities = std::map<std::pair<int, int>, std::vector<int>>;



    /// What there is to know about an element type of gmsh.
    struct ElementType
    {
      unsigned int dimension, n_nodes, n_corners;
    };



    ElementType element_type(const int type, const LineReader &lines)
    {
      static const std::map<int, ElementType> types = {
        { 15, { 0, 1, 1 } }, { 1, { 1, 2, 2 } }, { 8, { 1, 3, 2 } },
        { 2, { 2, 3, 3 } },  { 9, { 2, 6, 3 } }, { 3, { 2, 4, 4 } },
        { 16, { 2, 8, 4 } }, { 10, { 2, 9, 4 } }
      };
      const auto found = types.find(type);
      if (found == types.end())
        lines.fail("gmsh elements of type " + std::to_string(type) +
                     " are not supported",
                   "mesh a surface (gmsh -2) with lines, triangles and "
                   "quadrangles of first or second order");
      return found->second;
    }



    /// The rest of a line of $Elements: the nodes.
    std::vector<long> read_corners(const ElementType &type, LineReader &lines)
    {
      std::vector<long> nodes(type.n_nodes);
      for (long &node : nodes)
        node = lines.read<long>("the number of a node");

      // gmsh lists the corners first.
      nodes.resize(type.n_corners);
      return nodes;
    }



    Point<3> read_point(LineReader &lines)
    {
      Point<3> p;
      for (unsigned int d = 0; d < 3; ++d)
        p[d] = lines.read<double>("a coordinate");
      return p;
    }



    /// Parametric coordinates may follow on the line: not needed.
    void read_node(const long number, LineReader &lines, MshFile &msh)
    {
      if (!msh.nodes.emplace(number, read_point(lines)).second)
        lines.fail("node " + std::to_string(number) + " is defined twice",
                   "write the file again");
    }



    /// Returns the version, which decides how the other sections are read.
    std::string read_format(LineReader &lines)
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
        lines.fail("MSH format " + version +
                     " is not supported, only 2.2 and 4.1 are",
                   remedy);
      if (lines.read<int>("0 (ASCII) or 1 (binary)") != 0)
        lines.fail("the mesh file is binary, only ASCII is supported",
                   remedy + ", without the option -bin");

      lines.end("$MeshFormat");
      return version;
    }



    void read_names(LineReader &lines, MshFile &msh)
    {
      lines.next_in("$PhysicalNames");
      const auto n_names = lines.read<long>("the number of names");
      for (long i = 0; i < n_names; ++i)
        {
          lines.next_in("$PhysicalNames");
          const auto dimension = lines.read<unsigned int>("a dimension");
          const int  tag       = lines.read_tag();
          const auto name      = lines.read_quoted();
          if (dimension >= msh.names.size() || name.empty())
            lines.fail("expected: dimension tag \"name\"",
                       "write the file again");
          for (const auto &[other_tag, other_name] : msh.names[dimension])
            if (other_tag == tag || other_name == name)
              lines.fail("two physical groups of dimension " +
                           std::to_string(dimension) + " share the name '" +
                           name + "' or the tag " + std::to_string(tag),
                         "give every physical group a name of its own");
          msh.names[dimension][tag] = name;
        }
    }



    void read_nodes_22(LineReader &lines, MshFile &msh)
    {
      lines.next_in("$Nodes");
      const auto n_nodes = lines.read<long>("the number of nodes");
      for (long i = 0; i < n_nodes; ++i)
        {
          lines.next_in("$Nodes");
          read_node(lines.read<long>("the number of a node"), lines, msh);
        }
    }



    void read_nodes_41(LineReader &lines, MshFile &msh)
    {
      lines.next_in("$Nodes");
      const auto n_blocks = lines.read<long>("the number of entity blocks");
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
              read_node(number, lines, msh);
            }
        }
    }



    Entities read_entities(LineReader &lines)
    {
      lines.next_in("$Entities");
      std::array<long, 4> n_entities;
      for (long &n : n_entities)
        n = lines.read<long>("the number of entities");

      Entities entities;
      for (int dimension = 0; dimension < 4; ++dimension)
        for (long i = 0; i < n_entities[dimension]; ++i)
          {
            lines.next_in("$Entities");
            const auto tag = lines.read<int>("the tag of an entity");
            // The point itself, or the two corners of a bounding box.
            for (unsigned int p = 0; p < (dimension == 0 ? 1 : 2); ++p)
              read_point(lines);

            const auto n_groups = lines.read<long>("the number of groups");
            auto      &groups   = entities[{ dimension, tag }];
            for (long g = 0; g < n_groups; ++g)
              groups.push_back(lines.read_tag());
          }
      return entities;
    }



    void read_elements_22(LineReader &lines, MshFile &msh)
    {
      lines.next_in("$Elements");
      const auto n_elements = lines.read<long>("the number of elements");
      for (long i = 0; i < n_elements; ++i)
        {
          lines.next_in("$Elements");
          MshFile::Element element;
          element.number = lines.read<long>("the number of an element");
          const auto type =
            element_type(lines.read<int>("the type of an element"), lines);

          // The first tag is the physical group, 0 for none; what follows are
          // the entity and partitions.
          const auto n_tags = lines.read<long>("the number of tags");
          for (long t = 0; t < n_tags; ++t)
            if (const int tag = lines.read_tag(); t == 0 && tag != 0)
              element.groups.push_back(tag);

          element.nodes = read_corners(type, lines);
          msh.elements[type.dimension].push_back(std::move(element));
        }
    }



    void
    read_elements_41(const Entities &entities, LineReader &lines, MshFile &msh)
    {
      lines.next_in("$Elements");
      const auto n_blocks = lines.read<long>("the number of entity blocks");
      for (long block = 0; block < n_blocks; ++block)
        {
          lines.next_in("$Elements");
          const auto dimension = lines.read<int>("the dimension of an entity");
          const auto tag       = lines.read<int>("the tag of an entity");
          const auto type =
            element_type(lines.read<int>("the type of an element"), lines);
          const auto n_elements = lines.read<long>("the number of elements");

          const auto entity = entities.find({ dimension, tag });
          for (long i = 0; i < n_elements; ++i)
            {
              lines.next_in("$Elements");
              MshFile::Element element;
              element.number = lines.read<long>("the number of an element");
              element.nodes  = read_corners(type, lines);
              if (entity != entities.end())
                element.groups = entity->second;
              msh.elements[type.dimension].push_back(std::move(element));
            }
        }
    }
  } // namespace



  MshFile read_msh(const std::string &file)
  {
    MshFile msh;
    msh.name = file;

    LineReader        lines(file);
    const std::string version = read_format(lines);
    Entities          entities;
    while (lines.next())
      {
        const auto section = lines.read<std::string>("a section");
        if (section[0] != '$')
          lines.fail("expected a section, found '" + section + "'",
                     "write the file again");
        if (section == "$PhysicalNames")
          read_names(lines, msh);
        else if (section == "$Entities" && version == "4.1")
          entities = read_entities(lines);
        else if (section == "$Nodes")
          version == "2.2" ? read_nodes_22(lines, msh)
                           : read_nodes_41(lines, msh);
        else if (section == "$Elements")
          version == "2.2" ? read_elements_22(lines, msh)
                           : read_elements_41(entities, lines, msh);
        else
          {
            lines.skip(section);
            continue;
          }
        lines.end(section);
      }
    return msh;
  }
} // namespace Contact
