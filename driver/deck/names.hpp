// Names in decks, above all those that become names of files and of columns.
#ifndef PD_NAMES_HPP
#define PD_NAMES_HPP

#include <string>
#include <vector>

namespace pd {

/// What is wrong with an "Output Filename", or the name of a study, as the end of a sentence that begins with the key;
/// empty where nothing is. Results stay below the folder of the run, and every file made of the name can be told by
/// XDMF and JSON: a path without "..", control characters, quotes, colons and backslashes.
std::string complaintOfFileName(const std::string& name);

/// The same of a label of results, which stands in the heading of a CSV file, names a table of HDF5 files, and is an
/// attribute in XDMF. Refused is what numpy.genfromtxt, which knows no quotes, cannot tell from the rest of the
/// heading.
std::string complaintOfLabel(const std::string& label);

bool contains(const std::vector<std::string>& names, const std::string& name);

/// Line breaks, tabs and their like.
bool hasControlCharacter(const std::string& text);

}  // namespace pd

#endif
