// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/level.hpp>
#include <apart/core/toml_keys.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace apart {

/// Reads the tables [[block]], [[joint]] and [[ledge]] of a level, see level_file.hpp. Problems go
/// to `keys`. The kinds of the level must be read before.
class BuildingReader {
public:
    BuildingReader(TomlKeys& keys, Level& level) : keys_(keys), level_(level) {}

    void readBlock(const toml::table& table);
    void readKeep(const toml::table& root); // after all blocks
    void readJoint(const toml::table& table);
    void readLedge(const toml::table& table);

private:
    struct Pair {
        std::int32_t first = 0;
        std::int32_t second = 0;
    };
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

    Pair pair(const toml::table& table, const std::string& key, std::int32_t most,
              std::optional<Pair> otherwise);
    std::optional<std::uint8_t> kindOf(const toml::table& table);
    void readSize(const toml::table& table, FreeBlock& block);
    void readNumbers(const toml::table& table, LinkDef& link);
    Copies copiesOf(const toml::table& table);
    /// Calls `use` with the offset, the turn and the side (1 or -1) of each copy.
    static void forCopies(const Copies& copies,
                          const std::function<void(Pair offset, std::int32_t turn, int side)>& use);
    std::int32_t blockNamed(const toml::table& table, const std::string& key, std::int32_t copy);

    TomlKeys& keys_;
    Level& level_;
    std::map<std::string, std::int32_t> named_; // index into Level::freeBlocks
};

} // namespace apart
