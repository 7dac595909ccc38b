/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_msh_file_h
#define contact_msh_file_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iomanip>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "base/errors.h"
#include "base/files.h"

namespace Contact
{
  using namespace dealii;

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
        throw InputError("the mesh file cannot be opened",
                         file,
                         "check the name and the permissions of the file; a "
                         "relative name is relative to the parameter file, "
                         "with --set to the working directory");
      skip_byte_order_mark(input);
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
        fail("expected " + meaning + " in '" + legible(words.str()) + "'",
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
      const int tag = read<int>("the tag of a group");
      // The smallest number has no positive counterpart.
      if (tag == std::numeric_limits<int>::min())
        fail("the tag of a group is " + std::to_string(tag),
             "the file is damaged: write it again");
      return tag < 0 ? -tag : tag;
    }

    /// The first line of a section: how many entries follow.
    long count(const std::string &section)
    {
      next_in(section);
      return read<long>("the number of entries");
    }

    /// The last line of a section.
    void end(const std::string &section)
    {
      const std::string keyword = "$End" + section.substr(1);
      next_in(section);
      if (const auto found = read<std::string>(keyword); found != keyword)
        fail("expected " + keyword + ", found '" + legible(found) + "'",
             "the section announces another number of entries than it has: "
             "write the file again");
    }

    /// Pass over the lines of a section which is not needed.
    void skip(const std::string &section)
    {
      do
        next_in(section);
      while (read<std::string>("a word").find("$End" + section.substr(1)) != 0);
    }

    /// The beginning of a text that may be of any length, or no text at all.
    static std::string legible(std::string text)
    {
      const bool is_long = text.size() > 80;
      text.resize(std::min<std::size_t>(text.size(), 80));
      for (char &c : text)
        if (std::iscntrl(static_cast<unsigned char>(c)))
          c = '?';
      return text + (is_long ? "..." : "");
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



  /**
   * The content of a gmsh file, in gmsh's own numbers and before anything is
   * concluded from it: nodes, elements and physical groups.
   */
  struct MshFile
  {
    /// A point, a line, a triangle, a quadrangle, a hexahedron, a tetrahedron
    /// or, before it is split, a wedge or a pyramid.
    struct Element
    {
      /// gmsh's number, for messages.
      long number;

      /// The corners by node number, in gmsh's cyclic order, of volumes the
      /// bottom before the top; the mid-side and centre nodes of elements of
      /// second order are left out.
      std::vector<long> nodes;

      /// The named physical groups the element belongs to.
      std::set<std::string> groups;
    };

    /// The file's own name, for messages.
    std::string name;

    /// Node number -> coordinates.
    std::map<long, Point<3>> nodes;

    /// Corners of an edge or, of volumes, of a face or the volume itself, in
    /// ascending order -> the node on its middle.
    std::map<std::vector<long>, long> mid_sides;

    /// By dimension: points, lines, surfaces, volumes. All nodes exist. An
    /// element which the file repeats, as format 2.2 does for each of its
    /// groups, stands here once.
    std::array<std::vector<Element>, 4> elements;

    /// By dimension: tag of a physical group -> its name. None is empty.
    std::array<std::map<int, std::string>, 4> names;

    /// Body -> how many of its cells were split, see split_mixed_cells().
    std::map<std::string, unsigned int> n_split;

    /// That of the cells, which are volumes if the file has any.
    unsigned int dimension() const
    {
      return elements[3].empty() ? 2 : 3;
    }

    /// Whether not all cells are quadrangles (2-D) or hexahedra.
    bool has_simplices() const
    {
      const auto &cells = elements[dimension()];
      return std::any_of(cells.begin(), cells.end(), [&](const auto &cell) {
        return cell.nodes.size() != 1u << dimension();
      });
    }

    /// The place of an element, for messages.
    std::string where(const Element &element) const
    {
      return name + ", element " + std::to_string(element.number);
    }
  };



  /**
   * Read a gmsh file in MSH format 2.2 or 4.1, ASCII. Sections which are not
   * needed are skipped. Throws InputError with file and line if the file can
   * not be read, is of another format, is incomplete, or has elements other
   * than points, lines, triangles, quadrangles, hexahedra, tetrahedra, wedges
   * and pyramids of first or second order, nodes which do not exist, plane
   * cells out of a plane of constant z, no named body, or groups without
   * elements. Wedges and pyramids are split into tetrahedra, with what is
   * joined to them.
   */
  MshFile read_msh(const std::string &file);
} // namespace Contact

#endif
