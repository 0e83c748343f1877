// Reads triangles from STL (text and binary) and OBJ files.
#pragma once

#include <string>

#include "retiarius/bodies/shape.hpp"

namespace retiarius {

// The triangles of a file as they stand there, in file units; vertices may be repeated. The name
// must end in .stl or .obj. Throws InputError that names the file and, in text, the line: missing
// file, directory, empty file, unreadable text, numbers that are not finite.
TriangleMesh read_mesh(const std::string& path);

// The same for the content of a file; `path` is only named in errors.
TriangleMesh parse_stl(const std::string& content, const std::string& path);
TriangleMesh parse_obj(const std::string& content, const std::string& path);

// A number of a text file; throws InputError naming file and line if it is none or not finite.
double parse_coordinate(const std::string& word, const std::string& path, int line);

}  // namespace retiarius
