// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/editor/edit_document.hpp>
#include <apart/core/editor/level_edit.hpp>
#include <apart/core/editor/trial.hpp>
#include <apart/core/standing_trial.hpp>
#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/controls/controls.hpp>
#include <apart/stage/controls/player_settings.hpp>
#include <apart/stage/play/play.hpp>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace apart {

/// A level to edit, and where it goes.
struct EditorStart {
    Level level;
    std::string file; // shown
    /// Writes the text of the level. Returns a problem as a sentence, or "".
    std::function<std::string(const std::string& text)> save{};
    bool listed = false; // a level of the player: it stands among the levels once it is saved
};

/// What a press of the mouse in the field does.
enum class EditorTool : std::uint8_t { Select, Block, Ledge, Rope, Pin };

/// A button of the editor. Each has a key.
enum class EditorAct : std::uint8_t {
    Select,
    Ledge,
    Rope,
    Pin,
    Stuff, // EditorButton::value is one of the enumerators
    Hold,
    Shape,
    Undo,
    Redo,
    Mirror,
    Flip,
    Turn,
    Remove,
    Try,
    Map,
    Save,
    Leave,
};
struct EditorButton {
    EditorAct act;
    Aabb place; // m
    std::string label;
    std::size_t value = 0;
};

/// The editor of levels: a field with the level, and buttons beside it.
class EditorScreen {
public:
    /// What the stage has to do.
    enum class Wish : std::uint8_t { None, Try, Leave };

    EditorScreen(EditorStart start, const Settings& settings);

    Wish take(const Signals& signals, double now);
    /// Plays the trials of one frame: a bounded number of ticks.
    void advance();
    /// `now`: s, of animations and notices.
    void draw(Canvas& canvas, double now) const;

    const EditDocument& document() const { return document_; }
    const EditorStart& start() const { return start_; }
    bool wasSaved() const { return saves_ > 0; }
    /// The game of a try: the ball flies down from the pointer. Its level is one without records.
    std::unique_ptr<Play> trialPlay() const;
    static const std::vector<EditorButton>& buttons();

    // For tests and pictures.
    const LevelParts& chosen() const { return hand_.chosen; }
    const std::string& notice() const { return notice_; }
    const StandingTrial& standing() const { return *trials_.standing; }
    const std::optional<FallForecast>& forecast() const { return trials_.forecast; }
    const std::optional<ServeMap>& map() const { return trials_.map; }

private:
    /// The tool, and the block that it places.
    struct Tool {
        EditorTool tool = EditorTool::Select;
        Stuff stuff = Stuff::Brick;
        Support hold = Support::Standing;
        Form form = Form::Brick;
        std::int32_t turn = 0; // 1/1000 degree
        bool flip = false;
        EditStep larger; // than usual
    };
    struct Hand {
        Vec2 pointer{-100, -100};    // m
        std::optional<Vec2> pressed; // m, while the button is held
        LevelParts chosen;
        bool drags = false; // the chosen parts
        int rests = 0;      // frames since the pointer moved
    };
    struct Trials {
        std::unique_ptr<StandingTrial> standing;
        std::optional<FallForecast> forecast;
        std::optional<ServeMap> map;
    };

    void act(const EditorButton& button, double now);
    Wish leave(double now);
    void takeKey(int key, double now);
    void press();
    void release(double now);
    void change(Level level, double now);
    void changed();
    void say(std::string sentence, double now);
    void save(double now);
    FreeBlock blockInHand() const;
    /// The way of the dragged parts, or of the block in hand from the origin.
    EditStep step() const;

    // Pictures (editor_painter.cpp).
    void drawPanel(Canvas& canvas) const;
    void drawLamp(Canvas& canvas) const;
    void drawHand(Canvas& canvas) const;
    void drawTrials(Canvas& canvas, double now) const;
    std::string forecastText() const;
    bool isOn(const EditorButton& button) const;

    EditorStart start_;
    Settings settings_;
    EditDocument document_;
    std::unique_ptr<Play> play_; // the picture of the level
    Tool tool_;
    Hand hand_;
    Trials trials_;
    std::string notice_;
    double noticeAt_ = -100; // s
    int saves_ = 0;
};

} // namespace apart
