// The reference as Markdown.
#ifndef PD_MARKDOWN_HPP
#define PD_MARKDOWN_HPP

#include <string>
#include <vector>

#include "reference.hpp"

namespace pd {

/// One page a chapter: its keys and those of its topics, in tables of key, value, unit, range, default and meaning.
std::string markdownPage(const ReferenceChapter& chapter);

/// All pages of these chapters, one after another.
std::string markdown(const std::vector<ReferenceChapter>& chapters);

/// The whole reference: README.md, which names all pages, and a page a chapter. Returns their names. Throws
/// DeckError where pages of others are in the folder, RunError.
std::vector<std::string> writeReference(const std::string& folder);

}  // namespace pd

#endif
