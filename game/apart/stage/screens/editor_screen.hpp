// SPDX-License-Identifier: MIT
#pragma once

#include <apart/core/editor/edit_document.hpp>
#include <apart/core/editor/ground_edit.hpp>
#include <apart/core/editor/level_edit.hpp>
#include <apart/core/editor/trial.hpp>
#include <apart/core/standing_trial.hpp>
#include <apart/stage/canvas/canvas.hpp>
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/controls/controls.hpp>
#include <apart/stage/controls/player_settings.hpp>
#include <apart/stage/play/play.hpp>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
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
enum class EditorTool : std::uint8_t { Select, Block, Ledge, Rope, Pin, Ground };

/// A button of the editor. Most have a key.
enum class EditorAct : std::uint8_t {
    Select,
    Ledge,
    Rope,
    Pin,
    Ground,
    Turf,  // EditorButton::value is one of the enumerators
    Stuff, // likewise
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
int keyOf(const EditorButton& button); // or kNoKey

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
    /// The game of a try: the ball flies down from the pointer, or from where it stayed last in the
    /// field. Its level is one without records.
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
        Turf turf = Turf::Grass;
    };
    struct Hand {
        Vec2 pointer{-100, -100};    // m
        std::optional<Vec2> pressed; // m, while the button is held
        LevelParts chosen;
        bool drags = false;                   // the chosen parts
        bool free = false;                    // nothing snaps
        int rests = 0;                        // frames since the pointer moved
        double movedAt = -100;                // s, the pointer
        Vec2 field = layout::kField.center(); // m; where it stayed last in the field
        int repeated = kNoKey;                // the key that is held
        double repeatAt = 0;                  // s, its next effect
        bool repeats = false;                 // that effect is taking place
        std::shared_ptr<const Level> made;    // by a change since the last key was pressed
    };
    /// Ground that is drawn, or whose outline is changed.
    struct Outline {
        std::vector<GroundPoint> corners{}; // of one that is not finished
        std::optional<GroundGrip> grip{};   // of the chosen ground
        bool drags = false;                 // that grip
    };
    struct Trials {
        std::unique_ptr<StandingTrial> standing;
        std::optional<FallForecast> forecast;
        std::optional<ServeMap> map;
    };

    void act(const EditorButton& button, double now);
    Wish leave(double now);
    void takeKey(int key, double now);
    void repeat(int key, double now);
    void resize(EditStep larger, double now);
    void press();
    void release(double now);
    void change(Level level, double now);
    void changed();
    void say(std::string sentence, double now);
    void save(double now);
    void setTool(EditorTool tool);
    void setTurf(Turf turf, double now);
    void undo(bool again);
    void remove(double now);
    void nudge(EditStep step, double now);
    FreeBlock blockInHand() const;
    /// The way of the dragged parts, or of the block in hand from the origin.
    EditStep step() const;

    // Ground (editor_ground.cpp).
    const ObstructionDef* chosenGround() const; // the only chosen part; nullptr: it is no ground
    GroundPoint corner() const;                 // where the pointer puts one
    bool closes() const;                        // a click ends the outline
    bool pressGrip();
    void releaseGrip(Vec2 from, double now);
    void putCorner(GroundGrip grip, GroundPoint to, double now);
    void addCorner(double now);
    void finishGround(double now);
    void drawGround(Canvas& canvas) const;

    // Pictures (editor_painter.cpp).
    void drawPanel(Canvas& canvas) const;
    void drawLamp(Canvas& canvas) const;
    void drawHand(Canvas& canvas) const;
    void drawTrials(Canvas& canvas, double now) const;
    std::string forecastText() const;
    std::string_view hint() const;
    bool isOn(const EditorButton& button) const;

    EditorStart start_;
    Settings settings_;
    EditDocument document_;
    std::unique_ptr<Play> play_; // the picture of the level
    Tool tool_;
    Hand hand_;
    Outline outline_;
    Trials trials_;
    std::string notice_;
    double noticeAt_ = -100; // s
    int saves_ = 0;
};

} // namespace apart
