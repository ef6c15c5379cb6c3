#include "assets/gltf_numbers.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tumble {

namespace {

constexpr float kLargest = 1e9f;                         // so that squares and sums stay finite
constexpr std::size_t kMostIndices = 6 * kMostModelVertices;

// Rows of numbers in a buffer, known to lie inside it.
struct Rows {
  std::string_view bytes;   // from the first row on
  std::size_t stride = 0, width = 0;
  int type = 0;             // of a number, as in the file
  bool fractions = false;
};

template <class T>
T read(const char* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

// Whole numbers as fractions of their largest; signed ones down to -1.
template <class T>
double fraction(T value) {
  return std::max(static_cast<double>(value) / std::numeric_limits<T>::max(), -1.0);
}

double number_at(const Rows& rows, std::size_t row, std::size_t column) {
  const auto size = static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(rows.type)));
  const char* at = rows.bytes.data() + row * rows.stride + column * size;
  const auto whole = [&](auto value) { return rows.fractions ? fraction(value) : static_cast<double>(value); };
  switch (rows.type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return whole(read<std::int8_t>(at));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return whole(read<std::uint8_t>(at));
    case TINYGLTF_COMPONENT_TYPE_SHORT: return whole(read<std::int16_t>(at));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return whole(read<std::uint16_t>(at));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return read<std::uint32_t>(at);
    default: return read<float>(at);
  }
}

// `offset` and the row count come from the file and may be anything.
Rows rows_of(const GltfFile& file, int view, std::size_t offset, std::size_t count, std::size_t width, int type, const char* what) {
  const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type));
  if (size <= 0 || type == TINYGLTF_COMPONENT_TYPE_DOUBLE || type == TINYGLTF_COMPONENT_TYPE_INT)
    fail_model(file.name, what, " has numbers of an unknown kind (", type, "); export it again");
  Rows rows{view_bytes(file, view, what), file.records->bufferViews[static_cast<std::size_t>(view)].byteStride, width, type, false};
  const std::size_t row = width * static_cast<std::size_t>(size);
  if (rows.stride == 0) rows.stride = row;
  // `count` is limited and a stride is at most 252, so nothing here overflows.
  const std::size_t needed = count == 0 ? 0 : (count - 1) * rows.stride + row;
  if (offset > rows.bytes.size() || needed > rows.bytes.size() - offset)
    fail_model(file.name, what, " runs past its bytes (", count, " rows of ", row, " bytes in ", rows.bytes.size(), "); export it again");
  rows.bytes.remove_prefix(offset);
  return rows;
}

const tinygltf::Accessor& accessor_at(const GltfFile& file, int index, std::size_t limit, const char* what) {
  const auto& accessors = file.records->accessors;
  if (index < 0 || static_cast<std::size_t>(index) >= accessors.size())
    fail_model(file.name, what, " is accessor ", index, " of ", accessors.size(), "; export it again");
  const tinygltf::Accessor& accessor = accessors[static_cast<std::size_t>(index)];
  if (accessor.count > limit)
    fail_model(file.name, what, " has ", accessor.count, " entries; keep a model below ", limit);
  return accessor;
}

// Rows that differ from the others are kept apart in some files.
void apply_sparse(const GltfFile& file, const tinygltf::Accessor& accessor, GltfNumbers& numbers, const char* what) {
  const auto& sparse = accessor.sparse;
  if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > numbers.count || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0)
    fail_model(file.name, what, " has a faulty list of exceptions; export it again");
  const auto count = static_cast<std::size_t>(sparse.count);
  const Rows indices = rows_of(file, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count, 1, sparse.indices.componentType, what);
  Rows values = rows_of(file, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count, numbers.width, accessor.componentType, what);
  values.fractions = accessor.normalized;
  for (std::size_t i = 0; i < count; ++i) {
    const double row = number_at(indices, i, 0);
    if (!(row >= 0 && row < static_cast<double>(numbers.count))) fail_model(file.name, what, " has a faulty list of exceptions; export it again");
    for (std::size_t c = 0; c < numbers.width; ++c)
      numbers.values[static_cast<std::size_t>(row) * numbers.width + c] = static_cast<float>(number_at(values, i, c));
  }
}

}  // namespace

std::string_view view_bytes(const GltfFile& file, int view, const char* what) {
  const auto& views = file.records->bufferViews;
  if (view < 0 || static_cast<std::size_t>(view) >= views.size())
    fail_model(file.name, what, " is in buffer view ", view, " of ", views.size(), "; export it again");
  const tinygltf::BufferView& place = views[static_cast<std::size_t>(view)];
  if (place.buffer < 0 || static_cast<std::size_t>(place.buffer) >= file.buffers.size())
    fail_model(file.name, what, " is in buffer ", place.buffer, " of ", file.buffers.size(), "; export it again");
  const std::string_view buffer = file.buffers[static_cast<std::size_t>(place.buffer)];
  if (place.byteOffset > buffer.size() || place.byteLength > buffer.size() - place.byteOffset)
    fail_model(file.name, what, " runs past the end of buffer ", place.buffer, " (", buffer.size(), " bytes); copy or export it again");
  return buffer.substr(place.byteOffset, place.byteLength);
}

GltfNumbers read_numbers(const GltfFile& file, int index, std::size_t width, const char* what) {
  const tinygltf::Accessor& accessor = accessor_at(file, index, kMostModelVertices, what);
  if (tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)) != static_cast<int>(width))
    fail_model(file.name, what, " has not ", width, " numbers in a row; export it again");
  GltfNumbers numbers{accessor.count, width, std::vector<float>(accessor.count * width)};
  if (accessor.bufferView >= 0) {
    Rows rows = rows_of(file, accessor.bufferView, accessor.byteOffset, accessor.count, width, accessor.componentType, what);
    rows.fractions = accessor.normalized;
    for (std::size_t i = 0; i < numbers.values.size(); ++i) numbers.values[i] = static_cast<float>(number_at(rows, i / width, i % width));
  }
  if (accessor.sparse.isSparse) apply_sparse(file, accessor, numbers, what);
  for (const float value : numbers.values)
    if (!(std::abs(value) <= kLargest)) fail_model(file.name, what, " holds numbers that are not finite or above 1e9; export it again");
  return numbers;
}

std::vector<std::uint32_t> read_indices(const GltfFile& file, int index, std::size_t limit) {
  const tinygltf::Accessor& accessor = accessor_at(file, index, kMostIndices, "a list of indices");
  const Rows rows = rows_of(file, accessor.bufferView, accessor.byteOffset, accessor.count, 1, accessor.componentType, "a list of indices");
  std::vector<std::uint32_t> indices(accessor.count);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const double value = number_at(rows, i, 0);
    if (!(value >= 0 && value < static_cast<double>(limit)))
      fail_model(file.name, "a triangle wants vertex ", value, " of ", limit, "; export it again");
    indices[i] = static_cast<std::uint32_t>(value);
  }
  return indices;
}

}  // namespace tumble
