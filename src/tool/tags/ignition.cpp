#include "tags/ignition.h"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "tags/address.h"
#include "tags/names.h"

namespace merker::tags {
namespace {

using Json = nlohmann::ordered_json;

// Letters, digits, underscores, blanks and ' - : ( ); the first one a letter, digit or underscore.
std::string nameOf(const std::string& part) {
  const auto allowed = [](char c) {
    return isWordCharacter(c) || std::string_view(" '-:()").find(c) != std::string_view::npos;
  };
  std::string name = cleaned(part, allowed);
  const bool starts =
      !name.empty() && (static_cast<unsigned char>(name[0]) > 127 || isWordCharacter(name[0]));
  return starts ? name : "_" + name;
}

// Folders by the names of a path; each has names of its own.
class Folder {
 public:
  void add(const Tag& tag, std::size_t depth, Json leaf) {
    if (depth + 1 < tag.path.size()) {
      folders_.try_emplace(tag.path[depth], order_.size());
      const std::size_t at = folders_[tag.path[depth]];
      if (at == order_.size())
        order_.push_back({nameOf(tag.path[depth]), {}, std::make_unique<Folder>()});
      order_[at].folder->add(tag, depth + 1, std::move(leaf));
      return;
    }
    order_.push_back({nameOf(tag.path[depth]), std::move(leaf), nullptr});
  }

  Json json() {
    Json list = Json::array();
    UniqueNames unique;
    for (Entry& entry : order_) {
      Json row{{"name", unique(entry.name)}};
      if (entry.folder)
        row.update({{"tagType", "Folder"}, {"tags", entry.folder->json()}});
      else
        row.update(entry.leaf);
      list.push_back(std::move(row));
    }
    return list;
  }

 private:
  struct Entry {
    std::string name;
    Json leaf;
    std::unique_ptr<Folder> folder;
  };
  std::vector<Entry> order_;
  std::map<std::string, std::size_t> folders_;  // place in order_
};

Json leafOf(const Tag& tag, const std::string& place, const std::string& device) {
  return {{"tagType", "AtomicTag"},
          {"valueSource", "opc"},
          {"opcServer", "Ignition OPC UA Server"},
          {"opcItemPath", fmt::format("ns=1;s=[{}]{}", device, place)},
          {"dataType", kIgnition.tagType(tag.type)},
          {"readOnly", !tag.writable},
          {"documentation", tag.comment}};
}

}  // namespace

Output ignition(const std::vector<Tag>& tags, const FormatOptions& options) {
  Output output;
  Folder root;
  for (const Tag& tag : tags) {
    if (const auto place = address(tag, kIgnition))
      root.add(tag, 0, leafOf(tag, *place, options.device));
    else
      output.left.push_back(fullName(tag));
  }
  const Json document{{"name", ""}, {"tagType", "Provider"}, {"tags", root.json()}};
  output.text = document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  return output;
}

}  // namespace merker::tags
