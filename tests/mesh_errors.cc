/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

// Faults of a mesh file, or of the groups asked for, are reported: of each
// message the first line, of two the whole.

#include <functional>
#include <iostream>

#include "base/errors.h"
#include "mesh/mesh.h"
#include "mesh_files.h"

using namespace Contact;

void first_line(const std::function<void()> &read)
{
  try
    {
      read();
      std::cout << "NO ERROR" << std::endl;
    }
  catch (const InputError &error)
    {
      const std::string what = error.what();
      std::cout << what.substr(0, what.find('\n')) << std::endl;
    }
}



/// The text with one piece replaced, which has to be there.
std::string
replaced(std::string text, const std::string &piece, const std::string &by)
{
  const auto position = text.find(piece);
  AssertThrow(position != std::string::npos, ExcMessage("no " + piece));
  return text.replace(position, piece.size(), by);
}



// A fault of a file is reported with its place.
void test_file_errors()
{
  std::cout << "Errors in files" << std::endl;
  const auto read = [](const std::string &content) {
    first_line([&] { Mesh<2> mesh(parameters_for(content)); });
  };

  first_line([] {
    Parameters::Mesh parameters;
    parameters.file = "a_mesh_which_is_not_there.msh";
    Mesh<2> mesh(parameters);
  });
  first_line([] {
    Parameters::Mesh parameters;
    parameters.file = ".";
    Mesh<2> mesh(parameters);
  });
  read("");
  read("solid by another program\n");
  read(replaced(msh_22, "2.2 0 8", "2.2 1 8"));
  read(replaced(msh_22, "2.2 0 8", "4.0 0 8"));
  read(replaced(msh_41, "$Entities\n", "$PartitionedEntities\n"));

  // Truncated, and counts which are wrong.
  read(msh_22.substr(0, msh_22.find("6 2 1 0")));
  read(msh_41.substr(0, msh_41.find("2 2 3 1\n15")));
  read(replaced(msh_22, "$EndElements\n", ""));
  read(msh_22.substr(0, msh_22.find("a section nobody")));
  read(replaced(msh_22, "$Nodes\n11", "$Nodes\n10"));
  read(replaced(msh_22, "$Nodes\n11", "$Nodes\n12"));

  // Words and nodes.
  read(replaced(msh_22, "3 2 0 0", "3 2 zero 0"));
  read(replaced(msh_41, "9 5 4", "9 5"));
  read(replaced(msh_22, "14 3 2 9 1 1 2 5 4", "14 3 2 9 1 1 2 5 44"));
  read(replaced(msh_22, "3 2 0 0", "2 2 0 0"));
  read(replaced(msh_22, "3 2 0 0", "3 2 0 0.5"));

  // Elements.
  read(replaced(msh_22, "14 3 2 9 1 1 2 5 4", "14 92 2 9 1 1 2 5 4"));
  read(replaced(msh_22, "14 3 2 9 1 1 2 5 4", "14 3 2 9 1 1 5 2 4"));
  read(replaced(msh_22, "15 2 2 9 1 2 6 3", "15 2 2 9 1 1 2 3"));
  read(replaced(msh_22, "14 3 2 9 1 1 2 5 4", "14 3 2 9 1 1 2 3 5"));
  read(replaced(replaced(msh_22, "$Elements\n17", "$Elements\n18"),
                "14 3 2 9 1 1 2 5 4",
                "14 3 2 9 1 1 2 5 4\n18 2 2 9 1 2 6 4"));
}



// And what is wrong with groups.
void test_group_errors()
{
  std::cout << "Errors in groups" << std::endl;
  const auto read = [](const std::string &content) {
    first_line([&] { Mesh<2> mesh(parameters_for(content)); });
  };

  // Bodies: none, a cell of none, cells of two (in each format).
  read(replaced(
    replaced(replaced(msh_22, "2 9 \"Lower\"\n", ""), "2 10 \"Upper\"\n", ""),
    "$PhysicalNames\n10",
    "$PhysicalNames\n8"));
  read(replaced(msh_22, "14 3 2 9 1", "14 3 2 0 1"));
  read(replaced(replaced(msh_22, "$Elements\n17", "$Elements\n18"),
                "$EndElements",
                "18 3 2 10 1 2 5 4 1\n$EndElements"));
  read(replaced(msh_41, "1 9 4 1 2 5 4", "2 9 10 4 1 2 5 4"));

  // Names: empty groups, a name twice, none at all, of a volume.
  read(replaced(msh_22, "17 3 2 10 2", "17 3 2 9 2"));
  read(
    replaced(replaced(msh_22, "11 1 2 8", "11 1 2 0"), "12 1 2 8", "12 1 2 0"));
  read(replaced(msh_22, "\"Foot\"", "\"Bottom\""));
  read(replaced(msh_22, "\"Foot\"", ""));
  read(replaced(msh_22, "2 9 \"Lower\"", "3 9 \"Lower\""));

  // A line of a group that bounds no cell.
  read(replaced(msh_22, "11 1 2 8 3 5 4", "11 1 2 8 3 6 4"));

  // Groups asked for: what there is not, and what is of no use.
  const Mesh<2> mesh(parameters_for(msh_22));
  first_line([&] { mesh.body("Middle", "an entry"); });
  first_line([&] { mesh.boundary("Top", "an entry"); });
  first_line([&] { mesh.boundary("Inside", "an entry"); });
  first_line([&] { mesh.point("Bottom", "an entry"); });
  first_line([&] { mesh.point("Centre", "an entry"); });
  first_line([&] { mesh.point("Pair", "an entry"); });
  std::cout << mesh.body_name(mesh.body("Upper", "an entry")) << std::endl;

  // The whole message once: what, where, remedy.
  try
    {
      mesh.boundary("Top", "Contact/Slave");
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
  try
    {
      Mesh<2> damaged(parameters_for(replaced(msh_22, "5 1 1 0", "5 1 1")));
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }

  // An arc which is not one, and one which is no group.
  for (const std::string group : {"The top", "Round"})
    first_line([&] {
      auto parameters = parameters_for(msh_22);
      parameters.arcs = {{group, {1, 0, 1}}};
      Mesh<2> with_arc(parameters);
    });
}



int main()
{
  test_file_errors();
  test_group_errors();
  return 0;
}
