// tinygltf turns the file's text into records. It trusts offsets, reads 8 bytes past a wrong last chunk, recurses as deep
// as the text nests and copies the whole binary chunk for each buffer that asks for it. So the container, the nesting,
// the buffers and the pictures are seen to here, and it is given a text without them.
#include "assets/gltf_file.h"

#include <fstream>  // which tinygltf uses and does not include without a file system

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>

#include <algorithm>

#include "assets/game_path.h"

namespace tumble {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostText = 64 << 20;   // bytes of JSON; its records take some times as much
constexpr int kDeepest = 64;                  // tables in tables
constexpr std::size_t kMostBuffers = 256;
constexpr std::size_t kMostImages = 1024;

struct Container {
  std::string_view text, binary;
};

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (int i = 3; i >= 0; --i) word = word << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(i)]);
  return word;
}

// A .glb: twelve bytes of header, then chunks of length, kind and bytes.
Container open_container(std::string_view bytes, const std::string& name) {
  constexpr std::uint32_t kJson = 0x4e4f534a, kBinary = 0x004e4942;
  if (!bytes.starts_with("glTF")) return {bytes, {}};
  if (bytes.size() < 20) fail_model(name, "it ends within its header; export it again");
  if (word_at(bytes, 4) != 2) fail_model(name, "it is glTF version ", word_at(bytes, 4), "; export it as glTF 2.0");
  if (word_at(bytes, 8) > bytes.size())
    fail_model(name, "it says that it has ", word_at(bytes, 8), " bytes and has ", bytes.size(), "; copy or export it again");
  bytes = bytes.substr(0, word_at(bytes, 8));
  Container container;
  std::size_t at = 12;
  while (at + 8 <= bytes.size()) {
    const std::size_t length = word_at(bytes, at);
    const std::uint32_t kind = word_at(bytes, at + 4);
    if (length > bytes.size() - at - 8) fail_model(name, "its chunk at byte ", at, " runs past its end; export it again");
    if (kind == kJson && container.text.empty()) container.text = bytes.substr(at + 8, length);
    if (kind == kBinary && container.binary.empty()) container.binary = bytes.substr(at + 8, length);
    at += 8 + length;
  }
  if (container.text.empty()) fail_model(name, "it holds no text that describes it; export it again");
  return container;
}

// Seen to before the parser, whose own calls while it parses cost the square of a list's length.
void refuse_deep(std::string_view text, const std::string& name) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (in_string && letter == '\\') ++i;
    else if (letter == '"') in_string = !in_string;
    else if (!in_string && (letter == '[' || letter == '{')) ++depth;
    else if (!in_string && (letter == ']' || letter == '}')) --depth;
    if (depth > kDeepest) fail_model(name, "its text nests deeper than ", kDeepest, " levels; export it again");
  }
}

Json parse(std::string_view text, const std::string& name) {
  if (text.size() > kMostText) fail_model(name, "its text is ", text.size() >> 20, " MB long; keep vertices in a .bin or export a .glb");
  refuse_deep(text, name);
  try {
    Json json = Json::parse(text.begin(), text.end());
    if (!json.is_object()) fail_model(name, "its text is no table; give a .glb or .gltf file");
    return json;
  } catch (const Json::exception&) {
    fail_model(name, "it is neither a .glb nor the text of a .gltf; give a glTF 2.0 file");
  }
}

// The path in the game that a model's reference leads to: beside it, '..' and "%20" resolved; "" where it leads out.
std::string path_beside(const std::string& model, const std::string& reference) {
  const std::string decoded = tinygltf::dlib::urldecode(reference);
  std::vector<std::string> parts;
  const std::size_t slash = model.rfind('/');
  for (const std::string& text : {slash == std::string::npos ? std::string() : model.substr(0, slash), decoded})
    for (std::size_t at = 0; at <= text.size();) {
      const std::size_t end = std::min(text.find('/', at), text.size());
      const std::string part = text.substr(at, end - at);
      at = end + 1;
      if (part.empty() || part == ".") continue;
      if (part != "..") {
        parts.push_back(part);
        continue;
      }
      if (parts.empty()) return "";
      parts.pop_back();
    }
  std::string path;
  for (const std::string& part : parts) path += (path.empty() ? "" : "/") + part;
  return is_game_path(path) ? path : "";
}

std::string decoded(const GltfFile& file, const std::string& uri, const std::string& what) {
  const std::size_t comma = uri.find(";base64,");
  if (comma == std::string::npos || comma > 100) fail_model(file.name, what, " is given as text that is not base64; export it again");
  return tinygltf::base64_decode(uri.substr(comma + 8));
}

std::string other_file(GltfFile& file, const std::string& uri, const std::string& what) {
  const std::string path = path_beside(file.name, uri);
  std::optional<std::string> content = path.empty() ? std::nullopt : file.read(path);
  if (!content) fail_model(file.name, what, " is in '", uri.substr(0, 200), "', which is not in the game; put it beside the model or export a .glb");
  return std::move(*content);
}

void take_buffers(GltfFile& file, const Json& list, std::string_view binary) {
  if (!list.is_array() || list.size() > kMostBuffers) fail_model(file.name, "its buffers are not a list of at most ", kMostBuffers);
  file.owned.reserve(list.size());  // views into it must not move
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string what = "buffer " + std::to_string(i);
    if (!list[i].is_object()) fail_model(file.name, what, " is no table; export it again");
    const auto uri = list[i].find("uri");
    if (uri == list[i].end()) {
      if (i > 0 || binary.empty()) fail_model(file.name, what, " has no bytes; export it again");
      file.buffers.push_back(binary);
      continue;
    }
    if (!uri->is_string()) fail_model(file.name, what, " has an uri that is no text; export it again");
    file.owned.push_back(fetch(file, uri->get<std::string>(), what));
    file.buffers.push_back(file.owned.back());
  }
}

void take_images(GltfFile& file, const Json& list) {
  if (!list.is_array() || list.size() > kMostImages) fail_model(file.name, "its images are not a list of at most ", kMostImages);
  for (const Json& entry : list) {
    GltfImage& image = file.images.emplace_back();
    if (!entry.is_object()) continue;
    const auto view = entry.find("bufferView"), uri = entry.find("uri");
    if (view != entry.end() && view->is_number_integer()) image.view = view->get<int>();
    else if (uri != entry.end() && uri->is_string()) image.uri = uri->get<std::string>();
  }
}

// The library's sentences are several and end with line feeds.
std::string first_line(const std::string& text) {
  const std::string line = text.substr(0, std::min(text.find('\n'), std::size_t{200}));
  return line.empty() ? "its records are faulty" : line;
}

}  // namespace

std::string fetch(GltfFile& file, const std::string& uri, const std::string& what) {
  std::string content = uri.starts_with("data:") ? decoded(file, uri, what) : other_file(file, uri, what);
  file.fetched += content.size();
  if (file.fetched > kMaxFileBytes) fail_model(file.name, "with its files it is larger than ", kMaxFileBytes >> 20, " MB; make it smaller");
  return content;
}

GltfFile open_gltf(std::string_view bytes, const std::string& name, const ReadOther& read) {
  if (bytes.empty()) fail_model(name, "it is empty; export it again");
  const Container container = open_container(bytes, name);
  Json json = parse(container.text, name);

  GltfFile file;
  file.name = name;
  file.read = read;
  if (json.contains("buffers")) take_buffers(file, json["buffers"], container.binary);
  if (json.contains("images")) take_images(file, json["images"]);
  if (json.contains("nodes") && json["nodes"].size() > kMostModelNodes)
    fail_model(name, "it has ", json["nodes"].size(), " nodes; keep them below ", kMostModelNodes);
  json.erase("buffers");
  json.erase("images");

  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  json = {};
  file.records = std::make_shared<tinygltf::Model>();
  std::string error, warning;
  bool ok = false;
  try {
    ok = tinygltf::TinyGLTF().LoadASCIIFromString(file.records.get(), &error, &warning, text.data(), static_cast<unsigned>(text.size()), "");
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  if (!ok) fail_model(name, first_line(error), "; export it again as glTF 2.0");
  return file;
}

}  // namespace tumble
