// A browser that sends files to import and fetches zips; what it sends lies in a folder of the
// test.
#pragma once

#include <zip.h>

#include <algorithm>

#include "bench.h"
#include "workbench/base64.h"

namespace merker::workbench::test {

inline std::string base64(std::string_view text) {
  return toBase64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

inline std::string bytesOf(const std::string& text) {
  const auto bytes = fromBase64(text);
  EXPECT_TRUE(bytes) << text;
  return bytes ? std::string(bytes->begin(), bytes->end()) : "";
}

inline std::string zipOf(const std::map<std::string, std::string>& files) {
  const Folder folder;
  zip_t* zip = zip_open(folder.path("x.zip").c_str(), ZIP_CREATE, nullptr);
  for (const auto& [name, bytes] : files)
    zip_file_add(zip, name.c_str(), zip_source_buffer(zip, bytes.data(), bytes.size(), 0),
                 ZIP_FL_ENC_UTF_8);
  EXPECT_EQ(zip_close(zip), 0);
  return folder.read("x.zip");
}

inline constexpr const char* kMotorSource =
    "FUNCTION FC 7 : VOID\nBEGIN\nNETWORK\n  U E 0.0;\n  = A 0.0;\nEND_FUNCTION\n";

struct Transfer : ::testing::Test {
  Transfer() {
    bench.workbench.use({workspace.path(), {}, {}});
    ::setenv("TMPDIR", temporary.path().c_str(), 1);
  }
  ~Transfer() override { ::unsetenv("TMPDIR"); }

  void send(const std::string& path, std::string_view bytes, Workbench::BrowserId who = 1) {
    bench.call("import.add", {{"files", {{{"path", path}, {"data", base64(bytes)}}}}}, who);
  }
  std::string download() {
    const Json zip = bench.call("download.begin");
    std::string bytes;
    for (std::string piece; bytes.size() < zip["size"]; bytes += piece) {
      piece = bytesOf(bench.call("download.piece", {{"at", bytes.size()}})["data"]);
      if (piece.empty()) break;
    }
    EXPECT_EQ(bytes.size(), zip["size"]);
    return bytes;
  }
  static bool told(const Json& result, const std::string& effect, const std::string& words) {
    return std::ranges::any_of(result["report"], [&](const Json& row) {
      return row["effect"] == effect &&
             row["text"].get<std::string>().find(words) != std::string::npos;
    });
  }
  // Of all these files, without a look at them before.
  Json bring(const std::map<std::string, std::string>& files, Json fields = Json::object()) {
    bench.call("import.begin");
    for (const auto& [path, bytes] : files) send(path, bytes);
    return bench.call("import.run", std::move(fields));
  }
  // Of uploads that somebody still has.
  bool nothingLeft() const { return std::filesystem::is_empty(temporary.path()); }

  Bench bench;
  Folder workspace, temporary;
};

}  // namespace merker::workbench::test
