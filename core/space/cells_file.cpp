// SPDX-License-Identifier: GPL-3.0-or-later
//
// Layout, little-endian, every part padded with zeros to a multiple of 8 bytes:
//   8 bytes "slcells\n"; u32 version; u32 dimension; u64 size of the file; u64 hash of the scene; u64 primitives;
//   u64 length and text: the settings of the tessellation, a line FIELD=VALUE each;
//   u64 count and elements of each array in the order of for_each_array();
//   u64 checksum: Hash over all words before it.
#include "core/space/cells_file.h"

#include <bit>
#include <cstring>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/hash.h"
#include "core/base/number.h"
#include "core/base/output_file.h"
#include "core/space/builders.h"
#include "core/space/cells_check.h"

namespace sightline {

namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

constexpr std::string_view magic = "slcells\n";
constexpr std::uint32_t version = 1;
constexpr std::uint64_t largest_file = std::uint64_t{1} << 36;

struct Header {
    std::array<char, 8> magic;
    std::uint32_t version, dimension;
    std::uint64_t file_size, scene_hash, primitive_count;
};
static_assert(sizeof(Header) == 40);

std::size_t padded(std::size_t bytes) { return (bytes + 7) / 8 * 8; }

/// The arrays that cannot be worked out from others.
template <typename Cells, typename Visit>
void for_each_array(Cells& cells, Visit visit) {
    visit(cells.points);
    visit(cells.cell_points);
    visit(cells.half_facets);
    visit(cells.cell_facet_begin);
    visit(cells.facet_points);
    visit(cells.cell_primitive_begin);
    visit(cells.cell_primitives);
    visit(cells.tree.nodes);
    visit(cells.tree.leaves);
    visit(cells.leaf_cell);
}

std::string tessellation_settings(const TessellationSettings& settings) {
    std::string text = "tessellation=" + std::string(word(settings.tessellation)) +
                       "\nerror_bound=" + number_text(settings.error_bound) +
                       "\nborder=" + std::string(word(settings.border)) + "\njitter=" + number_text(settings.jitter) +
                       "\nseed=" + std::to_string(settings.seed) + "\n";
    // Younger than the first files: only where they are not at their defaults.
    const TessellationSettings defaults;
    if (settings.leaf_capacity != defaults.leaf_capacity)
        text += "leaf_capacity=" + std::to_string(settings.leaf_capacity) + "\n";
    if (settings.empty_leaves != defaults.empty_leaves)
        text += "empty_leaves=" + std::string(word(settings.empty_leaves)) + "\n";
    if (settings.neighbours != defaults.neighbours)
        text += "neighbours=" + std::string(word(settings.neighbours)) + "\n";
    if (settings.split_for != defaults.split_for)
        text += "split_for=" + std::string(word(settings.split_for)) +
                "\nopacity_tolerance=" + number_text(settings.opacity_tolerance) + "\n";
    return text;
}

/// Writes whole words and keeps the checksum of what went out.
class Writer {
public:
    explicit Writer(const std::filesystem::path& path) : file_(path) {}

    void bytes(const void* data, std::size_t size) {
        put({static_cast<const char*>(data), size / 8 * 8});
        if (size % 8 == 0) return;  // an array of nothing has no address either
        std::array<char, 8> last{};
        std::memcpy(last.data(), static_cast<const char*>(data) + size / 8 * 8, size % 8);
        put({last.data(), last.size()});
    }
    void word(std::uint64_t value) { bytes(&value, sizeof value); }
    void finish() {
        word(hash_.value());
        file_.commit();
    }

private:
    void put(std::string_view words) {
        for (std::size_t i = 0; i < words.size(); i += 8) {
            std::uint64_t word;
            std::memcpy(&word, words.data() + i, sizeof word);
            hash_.add(word);
        }
        file_.write(words);
    }

    OutputFile file_;
    Hash hash_;
};

class Reader {
public:
    Reader(const std::filesystem::path& path, std::string_view bytes) : path_(path), rest_(bytes) {}

    [[noreturn]] void fail(const std::string& reason) const { throw InputError(path_.string() + ": " + reason); }
    [[noreturn]] void damaged(const std::string& what) const { fail("is damaged: " + what); }

    /// The next part, without its padding.
    std::string_view bytes(std::uint64_t count, std::size_t element_size) {
        if (count > rest_.size() / element_size) damaged("a part is longer than the file");
        const std::string_view part = rest_.substr(0, static_cast<std::size_t>(count) * element_size);
        rest_.remove_prefix(std::min(rest_.size(), padded(part.size())));
        return part;
    }
    std::uint64_t word() {
        std::uint64_t value;
        std::memcpy(&value, bytes(1, sizeof value).data(), sizeof value);
        return value;
    }
    template <typename T>
    void array(std::vector<T>& out) {
        static_assert(std::is_trivially_copyable_v<T>);
        const std::uint64_t count = word();
        const std::string_view part = bytes(count, sizeof(T));
        out.resize(static_cast<std::size_t>(count));
        if (!part.empty()) std::memcpy(static_cast<void*>(out.data()), part.data(), part.size());
    }
    bool at_end() const { return rest_.empty(); }

private:
    const std::filesystem::path& path_;
    std::string_view rest_;
};

Header read_header(Reader& reader, std::string_view file, int dimension) {
    Header header;
    if (file.size() < sizeof header || !file.starts_with(magic)) reader.fail("is not a file of cells");
    std::memcpy(&header, reader.bytes(sizeof header, 1).data(), sizeof header);
    if (header.version != version)
        reader.fail("has version " + std::to_string(header.version) + " of the format, not " + std::to_string(version));
    if (header.file_size > file.size())
        reader.fail("is truncated: " + std::to_string(file.size()) + " of " + std::to_string(header.file_size) +
                    " bytes");
    if (header.file_size < file.size() || file.size() % 8 != 0) reader.damaged("it is longer than it says");
    Hash hash;
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < file.size(); i += 8) {
        std::memcpy(&word, file.data() + i, sizeof word);
        if (i + 8 < file.size()) hash.add(word);
    }
    if (word != hash.value()) reader.damaged("its checksum does not fit");
    if (header.dimension != static_cast<std::uint32_t>(dimension))
        reader.fail("holds cells in " + std::to_string(header.dimension) + " dimensions, not in " +
                    std::to_string(dimension));
    return header;
}

/// Throws with the first setting that differs.
void compare_settings(const Reader& reader, std::string_view stored, const std::string& asked) {
    const auto take_line = [](std::string_view& text) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        return line;
    };
    for (std::string_view rest = asked; !rest.empty() || !stored.empty();) {
        const std::string want(take_line(rest)), have(take_line(stored));
        if (have.empty()) reader.fail("was made without " + want);
        if (want.empty()) reader.fail("was made with " + have + ", which is not asked for");
        if (want != have) reader.fail("was made with " + have + ", not with " + want);
    }
}

template <int D>
std::uint32_t count_unassigned(const CellComplex<D>& cells, std::size_t primitive_count) {
    std::vector<bool> assigned(primitive_count);
    for (const std::uint32_t primitive : cells.cell_primitives) assigned[primitive] = true;
    return static_cast<std::uint32_t>(std::count(assigned.begin(), assigned.end(), false));
}

}  // namespace

template <int D>
void write_cells(const CellComplex<D>& cells, const Scene<D>& scene, const TessellationSettings& settings,
                 const std::filesystem::path& path) {
    const std::string text = tessellation_settings(settings);
    std::size_t size = sizeof(Header) + 8 + padded(text.size()) + 8;
    for_each_array(cells, [&](const auto& array) { size += 8 + padded(array.size() * sizeof array[0]); });
    Header header{{}, version, D, size, scene_hash(scene), scene.primitives.size()};
    std::copy(magic.begin(), magic.end(), header.magic.begin());

    Writer writer(path);
    writer.bytes(&header, sizeof header);
    writer.word(text.size());
    writer.bytes(text.data(), text.size());
    for_each_array(cells, [&](const auto& array) {
        writer.word(array.size());
        writer.bytes(array.data(), array.size() * sizeof array[0]);
    });
    writer.finish();
}

template <int D>
CellComplex<D> read_cells(const std::filesystem::path& path, const Scene<D>& scene,
                          const TessellationSettings& settings) {
    const std::string file = read_file(path, largest_file);
    Reader reader(path, file);
    const Header header = read_header(reader, file, D);
    if (const std::uint64_t hash = scene_hash(scene);
        header.scene_hash != hash || header.primitive_count != scene.primitives.size())
        reader.fail("was made for another scene (hash " + hash_text(header.scene_hash) + ", " +
                    std::to_string(header.primitive_count) + " primitives), not for '" + scene.id + "' (hash " +
                    hash_text(hash) + ", " + std::to_string(scene.primitives.size()) + " primitives)");
    const std::uint64_t text_size = reader.word();
    compare_settings(reader, reader.bytes(text_size, 1), tessellation_settings(settings));

    CellComplex<D> cells;
    cells.kind = settings.tessellation;
    for_each_array(cells, [&](auto& array) { reader.array(array); });
    reader.word();  // the checksum
    if (!reader.at_end()) reader.damaged("it holds more than it should");
    if (const char* what = fault(cells, scene.primitives.size())) reader.damaged(what);
    set_border_cells(cells);
    set_solidity_scales(cells);
    cells.unassigned = count_unassigned(cells, scene.primitives.size());
    return cells;
}

template void write_cells<2>(const CellComplex<2>&, const Scene<2>&, const TessellationSettings&,
                             const std::filesystem::path&);
template void write_cells<3>(const CellComplex<3>&, const Scene<3>&, const TessellationSettings&,
                             const std::filesystem::path&);
template CellComplex<2> read_cells<2>(const std::filesystem::path&, const Scene<2>&, const TessellationSettings&);
template CellComplex<3> read_cells<3>(const std::filesystem::path&, const Scene<3>&, const TessellationSettings&);

}  // namespace sightline
