// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/building_places.hpp>
#include <apart/core/legend_reader.hpp>
#include <apart/core/level.hpp>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace apart {

/// Reads the tables [[block]], [[joint]] and [[ledge]] of a level, see level_file.hpp. Problems go
/// to `keys`. The kinds of the level must be read before. A block with a fault is added too, so
/// that no other fault follows from it.
class BuildingReader {
public:
    BuildingReader(TomlKeys& keys, Level& level, Legend& legend)
        : keys_(keys), level_(level), legend_(legend), places_(keys) {}

    void readBlock(const toml::table& table);
    void readKeep(const toml::table& root); // after all blocks
    void readJoint(const toml::table& table);
    void readLedge(const toml::table& table);
    /// After all tables: too many blocks at one place, and names without a block.
    void finish();

    /// Blocks could not be read whose names begin with `prefix`.
    void doubtBlocks(const std::string& prefix);
    bool hasAllBlocks() const { return complete_; }

private:
    using Pair = TomlKeys::Pair;
    /// Copies of an entry of a table.
    struct Copies {
        std::int32_t count = 1;
        Pair step{};               // 1/1000 m, from one to the next
        std::int32_t stepTurn = 0; // 1/1000 degree
        std::int32_t rows = 1;
        Pair rowStep{}; // 1/1000 m, from one row to the next
        bool mirror = false;

        std::int32_t total() const { return count * rows * (mirror ? 2 : 1); }
    };

    /// A fault is named here; then the kind is one without known keys.
    std::uint8_t kindOf(const toml::table& table);
    std::uint8_t unknownKind();
    void readSize(const toml::table& table, FreeBlock& block);
    void checkThickness(const toml::table& table, const FreeBlock& block);
    void addCopies(const toml::table& table, const FreeBlock& block, const Copies& copies,
                   const std::string& name, bool placed);
    void readNumbers(const toml::table& table, LinkDef& link);
    Copies copiesOf(const toml::table& table);
    /// Calls `use` with the offset, the turn and the side (1 or -1) of each copy.
    static void forCopies(const Copies& copies,
                          const std::function<void(Pair offset, std::int32_t turn, int side)>& use);
    /// Index into Level::freeBlocks; nullopt after a fault, here or of the block.
    std::optional<std::int32_t> blockNamed(const toml::table& table, const std::string& key,
                                           std::int32_t copy);
    void addLinks(const toml::table& table, const LinkDef& link, bool placed);
    /// True if a table with `more` entries of the level would exceed the limit: a fault at the
    /// first one.
    bool exceeds(const toml::table& table, std::size_t& total, std::int32_t more, std::size_t most,
                 const std::string& things);

    TomlKeys& keys_;
    Level& level_;
    Legend& legend_;
    BuildingPlaces places_;
    std::map<std::string, std::int32_t> named_; // index into Level::freeBlocks
    std::vector<std::string> doubtful_;         // starts of names of blocks that are not in named_
    std::map<std::string, std::set<int>> nameless_; // lines by name without a block
    bool complete_ = true;                          // all blocks could be read
    // Entries of the level so far, copies included.
    std::size_t blocks_ = 0;
    std::size_t ledges_ = 0;
    std::size_t joints_ = 0;
};

} // namespace apart
