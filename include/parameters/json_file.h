/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#ifndef contact_json_file_h
#define contact_json_file_h

#include <string>
#include <vector>

namespace Contact
{
  /// A value of a JSON file, which knows its name and the line of that.
  struct JsonValue
  {
    enum class Type
    {
      null,
      scalar, // text, number, true or false
      array,
      object
    };

    Type         type = Type::null;
    std::string  name;     // in the object it belongs to, if it is one
    unsigned int line = 1; // of the name
    std::string  text;     // of a scalar; a number as it is written

    /// Of an array or an object, in the order of the file.
    std::vector<JsonValue> elements;

    /// The element @p name of an object; none: a null pointer.
    const JsonValue *find(const std::string &name) const;

    /// The kind of the value, in words for messages.
    std::string description() const;
  };

  /**
   * Read the text of the file @p file. Throws InputError, with line and column,
   * if it is no JSON, if an object has two elements of one name, or if it is
   * nested more deeply than any case.
   */
  JsonValue parse_json(const std::string &text, const std::string &file);
} // namespace Contact

#endif
