// SPDX-License-Identifier: MIT
#include <apart/core/assets.hpp>
#include <apart/core/run.hpp>
#include <apart/core/tuning.hpp>
#include <apart/sfml/film.hpp>
#include <apart/sfml/sfml_canvas.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/painters/backdrop.hpp>

#include <SFML/Graphics/RenderTexture.hpp>

#include <algorithm>
#include <array>
#include <vector>

#ifdef APART_GIF
#include <gif_lib.h>
#endif

namespace apart {

#ifdef APART_GIF

namespace {

constexpr kodo_draw::Size kFilmPixels{480, 372};
constexpr double kFrameSeconds = 0.1; // of the rerun, which is in slow motion
constexpr int kFrameTime = 6;         // 1/100 s
constexpr std::uint32_t kMostFrames = 240;

// Colours: 6 levels of red, 7 of green, 6 of blue; then the one that leaves a pixel as it was.
constexpr int kReds = 6;
constexpr int kGreens = 7;
constexpr int kBlues = 6;
constexpr int kUnchanged = 252;

/// The level of a colour with an ordered dither by a matrix of 4 by 4 [Bayer, 1973].
int levelOf(int value, int levels, unsigned x, unsigned y) {
    constexpr std::array<int, 16> kBayer = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    const int threshold = 2 * kBayer[4 * (y % 4) + x % 4] + 1; // of 32
    return (value * (levels - 1) * 32 + threshold * 255) / (255 * 32);
}

ColorMapObject* makeColors() {
    std::array<GifColorType, 256> colors{};
    const auto byteOf = [](int level, int levels) {
        return static_cast<GifByteType>(level * 255 / (levels - 1));
    };
    for (int i = 0; i < kReds * kGreens * kBlues; ++i) {
        colors[static_cast<std::size_t>(i)] = {byteOf(i / (kGreens * kBlues), kReds),
                                               byteOf(i / kBlues % kGreens, kGreens),
                                               byteOf(i % kBlues, kBlues)};
    }
    return GifMakeMapObject(256, colors.data());
}

/// A GIF file that is being written. Pixels that do not change from one frame to the next are left
/// out, which makes it small.
class GifFile {
public:
    explicit GifFile(const std::string& path) : colors_(makeColors()) {
        int error = 0;
        file_ = EGifOpenFileName(path.c_str(), false, &error);
        if (file_ == nullptr || colors_ == nullptr) {
            return;
        }
        EGifSetGifVersion(file_, true);
        const int width = static_cast<int>(kFilmPixels.x);
        const int height = static_cast<int>(kFilmPixels.y);
        good_ = EGifPutScreenDesc(file_, width, height, 8, 0, colors_) == GIF_OK && putLoop();
    }
    ~GifFile() {
        GifFreeMapObject(colors_);
        int error = 0;
        if (file_ != nullptr) {
            EGifCloseFile(file_, &error);
        }
    }
    GifFile(const GifFile&) = delete;
    GifFile& operator=(const GifFile&) = delete;

    void add(const sf::Image& image) {
        const sf::Vector2u size = image.getSize();
        std::vector<GifPixelType> pixels(std::size_t{size.x} * size.y);
        const sf::Uint8* from = image.getPixelsPtr();
        for (std::size_t i = 0; i < pixels.size(); ++i, from += 4) {
            const auto x = static_cast<unsigned>(i % size.x);
            const auto y = static_cast<unsigned>(i / size.x);
            const int red = levelOf(from[0], kReds, x, y);
            const int green = levelOf(from[1], kGreens, x, y);
            const int blue = levelOf(from[2], kBlues, x, y);
            pixels[i] = static_cast<GifPixelType>((red * kGreens + green) * kBlues + blue);
        }
        std::vector<GifPixelType> shown = pixels;
        for (std::size_t i = 0; i < last_.size(); ++i) {
            shown[i] = pixels[i] == last_[i] ? GifPixelType{kUnchanged} : pixels[i];
        }
        last_ = std::move(pixels);
        const GraphicsControlBlock control{DISPOSE_DO_NOT, false, kFrameTime, kUnchanged};
        std::array<GifByteType, 4> bytes{};
        EGifGCBToExtension(&control, bytes.data());
        const int width = static_cast<int>(size.x);
        const int height = static_cast<int>(size.y);
        good_ = good_ &&
                EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, 4, bytes.data()) == GIF_OK &&
                EGifPutImageDesc(file_, 0, 0, width, height, false, nullptr) == GIF_OK &&
                EGifPutLine(file_, shown.data(), width * height) == GIF_OK;
    }

    bool good() const { return good_; }

private:
    /// The extension by which viewers repeat the film.
    bool putLoop() {
        constexpr std::array<GifByteType, 3> kForever = {1, 0, 0};
        return EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
               EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0") == GIF_OK &&
               EGifPutExtensionBlock(file_, 3, kForever.data()) == GIF_OK &&
               EGifPutExtensionTrailer(file_) == GIF_OK;
    }

    GifFileType* file_ = nullptr;
    ColorMapObject* colors_ = nullptr;
    std::vector<GifPixelType> last_; // of the last frame
    bool good_ = false;
};

} // namespace

std::string writeFilm(Rerun fall, const std::string& path) {
    sf::RenderTexture target;
    if (!target.create(kFilmPixels.x, kFilmPixels.y)) {
        return "There is no display to draw the film with.";
    }
    GifFile file(path);
    SfmlCanvas canvas(assetsFolder() / "fonts", kFilmPixels);
    const auto frames = static_cast<std::uint32_t>(fall.seconds() / kFrameSeconds);
    for (std::uint32_t i = 0; i < std::min(frames, kMostFrames) && file.good(); ++i) {
        canvas.begin(layout::kField.grown(layout::kFrame), {});
        paintBackdrop(canvas, fall.play().game().level().theme, 0);
        fall.play().draw(canvas, fall.share(), layout::kField);
        target.clear();
        canvas.picture().draw(target);
        target.display();
        file.add(target.getTexture().copyToImage());
        fall.advance(kFrameSeconds);
    }
    return file.good() ? "" : "The film cannot be written to " + path + ".";
}

#else

std::string writeFilm(Rerun, const std::string&) {
    return "This build has no giflib, so it writes no films.";
}

#endif

std::string filmReplay(const std::string& replay, const std::string& path,
                       const std::filesystem::path& ownLevels) {
    const Read<ReplayRun> read = readRunFile(replay);
    if (const auto* problem = std::get_if<FileProblem>(&read)) {
        return problem->text() + ".";
    }
    std::optional<Rerun> largest;
    std::int32_t blocks = 0;
    for (const Replay& game : std::get<ReplayRun>(read)) {
        const Read<Level> level = loadLevelOf(replay, game.level, ownLevels);
        if (const auto* problem = std::get_if<FileProblem>(&level)) {
            return problem->text() + ".";
        }
        if (const auto reason = refusal(game, std::get<Level>(level))) {
            return replay + " " + *reason + ".";
        }
        std::optional<Fall> fall =
            largestFall(game, std::make_shared<const Level>(std::get<Level>(level)));
        if (fall && fall->blocks > blocks) {
            blocks = fall->blocks;
            largest = std::move(fall->rerun);
        }
    }
    return largest ? writeFilm(std::move(*largest), path) : "Nothing falls in this replay.";
}

} // namespace apart
