// SPDX-License-Identifier: MIT
#include <apart/stage/canvas/layout.hpp>
#include <apart/stage/canvas/palette.hpp>
#include <apart/stage/painters/backdrop.hpp>
#include <apart/stage/painters/logo.hpp>
#include <apart/stage/screens/ending.hpp>
#include <apart/stage/screens/help.hpp>
#include <apart/stage/screens/results.hpp>
#include <apart/stage/screens/statistics_page.hpp>
#include <apart/stage/screens/title.hpp>
#include <apart/stage/stage.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace apart {

namespace {

constexpr Real kLineRoom = 30; // m, of a line on a screen that is centred on the field

constexpr TextStyle quiet(Real height, Real room = kLineRoom) {
    return {height, palette::kQuiet, Typeface::Plain, Align::Middle, room};
}

/// Place of notices at the lower edge.
struct NoticeRoom {
    std::size_t lines;
    std::size_t letters; // per line
    Real width;          // m
    Color color;
};
constexpr NoticeRoom kTitleNotices{3, 120, kLineRoom, palette::kQuiet};
constexpr NoticeRoom kGameNotices{2, 92, 2 * layout::kRight - Real(0.6), palette::kAccent};

/// Notices stacked from the bottom, latest last. Older ones are omitted if they do not fit below
/// the menu.
void paintNotices(Canvas& canvas, const std::vector<std::string>& notices, const NoticeRoom& room) {
    std::vector<std::string> lines;
    for (std::size_t i = notices.size(); i-- > 0;) {
        const std::vector<std::string> own =
            wrappedInto(room.lines, notices[i], fitting(canvas, room.letters));
        if (!lines.empty() && lines.size() + own.size() > room.lines) {
            break;
        }
        lines.insert(lines.begin(), own.begin(), own.end());
    }
    Real y = Real(0.1);
    for (std::size_t i = lines.size(); i-- > 0;) {
        canvas.text(lines[i], {0, y},
                    {Real(0.42), room.color, Typeface::Plain, Align::Middle, room.width});
        y += Real(0.62);
    }
}

/// The errors of the level file that is being edited, or news of it, as many as there is room for.
void paintReload(Canvas& canvas, const Reload& reload, double now) {
    const bool news = reload.hasNews(now);
    const std::vector<std::string> sentences =
        news ? std::vector<std::string>{reload.news} : reload.faults;
    const Color color = news ? palette::kText : palette::kDanger;
    constexpr std::size_t kLetters = 90; // per line
    constexpr Real kTop = Real(16.8);    // m, of the first line
    constexpr Real kLine = Real(0.6);    // m
    std::vector<std::string> lines;
    for (const std::string& sentence : sentences) {
        const std::vector<std::string> own = wrapped(sentence, fitting(canvas, kLetters));
        lines.insert(lines.end(), own.begin(), own.end());
    }
    const auto room = static_cast<std::size_t>(kTop / kLine);
    if (lines.size() > room) {
        lines.resize(room - 1);
        lines.emplace_back("...");
    }
    Real y = kTop;
    for (const std::string& line : lines) {
        canvas.rectangle({{Real(-11.8), y - Real(0.15)}, {Real(11.8), y + Real(0.45)}},
                         faded(palette::kInk, 0.9f), faded(palette::kInk, 0.9f));
        canvas.text(line, {Real(-11.5), y},
                    {Real(0.4), color, Typeface::Plain, Align::Left, Real(23)});
        y -= kLine;
    }
}

void paintHeading(Canvas& canvas, std::string_view text) {
    canvas.text(text, {0, Real(14.4)},
                {Real(1.4), palette::kText, Typeface::Display, Align::Middle});
}

void paintOptions(Canvas& canvas, const Menu& menu, std::string_view question, bool fingers) {
    paintVeil(canvas, faded(palette::kNight, 0.80f));
    paintHeading(canvas, "Options");
    canvas.text(fingers ? "tap a bar or a word" : "left and right, or a click on the bar",
                {0, Real(1.7)}, quiet(Real(0.42)));
    paintQuestion(canvas, question, Real(0.3));
    menu.draw(canvas);
}

void paintReplays(Canvas& canvas, const Menu& menu, const std::string& folder) {
    paintVeil(canvas, faded(palette::kNight, 0.80f));
    paintHeading(canvas, "Replays");
    canvas.text("files in " + folder, {0, Real(0.35)}, quiet(Real(0.42)));
    menu.draw(canvas);
}

/// The lines below a result; the most important is the last. `entered`: the records
/// that it was entered in, or nullptr.
std::vector<std::string> resultNotes(const Reload& reload, const std::vector<std::string>& notes,
                                     const Records* entered) {
    std::vector<std::string> all = reload.notes();
    all.insert(all.end(), notes.begin(), notes.end());
    if (entered != nullptr) {
        all.insert(all.end(), entered->lost().begin(), entered->lost().end());
    }
    return all;
}

constexpr Real kFeastFoot = Real(13.9); // m; a won game has its words above it

/// The part of the field for words of the game (m): the middle is left to the fall.
Aabb roomForWords(const Game& game, const Closeup& closeup) {
    Aabb room = shownBy(closeup);
    if (game.result() == Result::Won) {
        room.upper.y = closeup.focus.y + (kFeastFoot - closeup.focus.y) / closeup.scale;
    }
    return room;
}

/// `ticks` since the end of a won game.
void paintFeast(Canvas& canvas, int ticks, const Bindings& keys) {
    const float t = std::min(static_cast<float>(ticks) / 30, 1.0f);
    const Real size = Real(2.4) - Real(0.5) * t; // shrinks to its final size
    const auto line = [&](std::string_view text, Real y, TextStyle style) {
        style.color = faded(style.color, t);
        TextStyle shadow = style;
        shadow.color = faded(palette::kInk, t);
        canvas.text(text, {Real(0.07), y - Real(0.07)}, shadow);
        canvas.text(text, {0, y}, style);
    };
    line("Cleared!", Real(15.5), {size, palette::kAccent, Typeface::Display, Align::Middle});
    line(keys.anyPrompt(Act::Serve) + ": go on", Real(14.4),
         {Real(0.5), palette::kText, Typeface::Bold, Align::Middle});
}

/// The idea of the level stands above: before the serve there may be no room for it.
void paintPaused(Canvas& canvas, const Menu& menu, std::string_view question, const HudLook& look,
                 const Level& level) {
    paintVeil(canvas, faded(palette::kNight, 0.72f));
    const Real top = menu.place(0).upper.y;
    canvas.text("Paused", {0, top + Real(1.4)},
                {Real(1.6), palette::kText, Typeface::Display, Align::Middle});
    menu.draw(canvas);
    constexpr Real kIdeaRoom = 2 * layout::kRight - Real(0.6);
    Real y = Real(16.9);
    for (const std::string& line : wrappedInto(2, level.idea, fitting(canvas, 80), 90)) {
        canvas.text(line, {0, y},
                    {Real(0.5), palette::kText, Typeface::Plain, Align::Middle, kIdeaRoom});
        y -= Real(0.8);
    }
    y = Real(4.9);
    const auto prompt = [&](Act act) { return look.keys.anyPrompt(act); };
    const std::string move = look.keys.fingers ? "a finger: move"
                                               : fmt::format("mouse; {}: left; {}: right",
                                                             prompt(Act::Left), prompt(Act::Right));
    for (const std::string& line :
         {fmt::format("{}      {}: serve", move, prompt(Act::Serve)),
          fmt::format("{}: pull      {}: push", prompt(Act::Pull), prompt(Act::Push)),
          look.keys.fingers
              ? std::string{}
              : fmt::format("{}: start again      {}: sound      F3: what the engine sees",
                            prompt(Act::Restart), prompt(Act::Mute))}) {
        canvas.text(line, {0, y}, quiet(Real(0.42), 2 * layout::kRight));
        y -= Real(0.7);
    }
    if (look.takenOver) {
        canvas.text(look.foot + ": from there you play. The score does not count.",
                    {0, top + Real(0.35)}, quiet(Real(0.5), 2 * layout::kRight - Real(0.6)));
    }
    paintQuestion(canvas, question, Real(1.6));
}

/// The pending question of a game. One that ends a run in its first level says what is lost.
std::string questionOf(std::string_view question, const Session& session, const EndlessRun& run) {
    const bool first = session.kind() == Session::Kind::Own && run.number > 0 && run.before.empty();
    return std::string(question) +
           (question.empty() || !first ? "" : ": left in its first level, a run has no score");
}

/// What the bot's game behind the title says once there is no menu.
void paintAttract(Canvas& canvas, double seconds) {
    const float pulse = 0.6f + 0.4f * static_cast<float>(std::sin(2 * seconds));
    paintLogo(canvas, {0, Real(4.3)}, Real(1.3), seconds);
    canvas.text("press any key", {0, Real(3.2)},
                {Real(0.6), faded(palette::kText, pulse), Typeface::Bold, Align::Middle});
}

std::string titleHint(bool fingers, bool quits) {
    return fingers ? "tap a word"
           : quits ? "arrows and enter, or the mouse      escape: quit"
                   : "arrows and enter, or the mouse";
}

/// `hint`: where there are no notices.
void paintTitleScreen(Canvas& canvas, const Menu& menu, double seconds,
                      const std::vector<std::string>& notices, std::string_view question,
                      const std::string& hint) {
    paintVeil(canvas, faded(palette::kNight, 0.74f));
    paintTitle(canvas, seconds);
    menu.draw(canvas);
    if (question.empty()) {
        paintNotices(canvas, notices.empty() ? std::vector{hint} : notices, kTitleNotices);
    }
    paintQuestion(canvas, question, Real(-0.2)); // in the place of the notices
}

} // namespace

ShownGame shownBy(const Stage& stage) {
    const bool help = stage.screen_ == Screen::Help && stage.pages_.help;
    const bool wide = (stage.session().isDemo() && stage.screen_ != Screen::Editor) || help;
    if (stage.games_.end().rerun) {
        return {stage.games_.end().rerun->play().game(), {}, wide};
    }
    return {stage.session().game(), wide ? Closeup{} : stage.session().closeup(), wide};
}

void paintOver(Canvas& canvas, const Stage& stage) {
    const GameEnd& end = stage.games_.end();
    const EndlessRun& run = stage.games_.run();
    if (stage.screen_ == Screen::Ending) {
        paintEnding(canvas, stage.session().game(), stage.session().statistics(),
                    tallyOf(stage.def_.levels, stage.def_.campaign, stage.records_.profile(),
                            stage.records_.marks()));
        return stage.menu_.draw(canvas);
    }
    paintVeil(canvas, faded(palette::kNight, end.rerun ? 0.66f : 0.72f));
    paintResults(canvas, {stage.session().game(), stage.session().statistics(),
                          stage.session().game().score() + (run.number > 0 ? run.score : 0),
                          end.newBest, stage.over_.seconds,
                          run.number > 0 ? std::span<const MedalMarks>() : stage.records_.marks()});
    paintNotices(
        canvas,
        resultNotes(stage.reload_, stage.over_.notes, end.entered ? &stage.records_ : nullptr),
        kGameNotices);
    if (stage.def_.sharing.copy) {
        const bool film = stage.def_.sharing.film && end.rerun;
        const bool fingers = stage.records_.profile().bindings.fingers;
        canvas.text(fingers ? "the chain symbol: copy a link to this game"
                    : film  ? "C: copy a link to this game      G: film of the fall"
                            : "C: copy a link to this game",
                    {0, Real(16.7)}, quiet(Real(0.42)));
    }
    stage.menu_.draw(canvas);
}

/// Words over a game or a replay, and the pending question.
void paintPlaying(Canvas& canvas, const Stage& stage, std::string_view question) {
    const Session& session = stage.session();
    if (session.isShow()) {
        paintReload(canvas, stage.watched_.divergence, stage.seconds_);
        return paintTheatre(canvas, stage.games_.theatre(), session.clock(),
                            stage.watched_.list.leadsFrom(session) ? "all replays" : "menu");
    }
    const Bindings& keys = stage.records_.profile().bindings;
    const Reload& reload = stage.reload_;
    paintReload(canvas, reload, stage.seconds_);
    paintQuestion(canvas, question, Real(4.3)); // if there is one
    if (question.empty() && reload.faults.empty() && !reload.hasNews(stage.seconds_) &&
        !stage.inputMapper_.aims()) {
        paintServeHint(canvas, session.game(), keys);
    }
    if (session.game().result() == Result::Won) {
        paintFeast(canvas, session.endTicks(), keys);
    }
}

void Stage::draw(Canvas& canvas) const {
    const bool help = screen_ == Screen::Help && pages_.help;
    const ShownGame shown = apart::shownBy(*this);
    const Closeup& closeup = shown.closeup;
    const bool still = help || screen_ == Screen::Duel;
    canvas.begin(shown.wide ? layout::kShownTitle : layout::kShown,
                 still ? Vec2{} : session().play().juice().shake());
    canvas.setPalette(static_cast<Vision>(std::clamp(records_.profile().settings.colors, 0, 3)));
    canvas.setTextScale(static_cast<Real>(records_.profile().settings.text) / 100);
    if (help) {
        return pages_.help->draw(canvas, records_.profile().bindings);
    }
    if (screen_ == Screen::Editor) {
        return editor_->draw(canvas, seconds_);
    }
    if (screen_ == Screen::Duel) {
        return duel_->draw(canvas, records_.profile().bindings);
    }
    const bool words = screen_ == Screen::Playing || attracting();
    canvas.zoom(closeup.focus, closeup.scale);
    paintBackdrop(canvas, session().game().level().theme, seconds_);
    if (games_.end().rerun) {
        games_.end().rerun->play().draw(canvas, games_.end().rerun->share(), layout::kShown, words);
    } else {
        session().play().draw(canvas, session().share(), roomForWords(session().game(), closeup),
                              words);
        if (session().ghost() && screen_ < Screen::Over) {
            session().ghost()->draw(canvas, session().share(),
                                    share(records_.profile().settings.ghost));
        }
    }
    canvas.zoom({}, 1);
    if (closeup.scale > 1) {
        paintPanelBack(canvas, session().game().level().theme);
    }
    if (!shown.wide) {
        paintHud(canvas, session().game(), hudLookOf(*this));
    }
    const std::string question = questionOf(confirm_.question(seconds_), session(), games_.run());
    switch (screen_) {
    case Screen::Title:
        return attracting()
                   ? paintAttract(canvas, seconds_)
                   : paintTitleScreen(canvas, menu_, seconds_, records_.notices(),
                                      confirm_.question(seconds_),
                                      titleHint(records_.profile().bindings.fingers, def_.quits));
    case Screen::Levels:
        return map_.draw(canvas, records_, seconds_);
    case Screen::Options:
        return paintOptions(canvas, menu_, confirm_.question(seconds_),
                            records_.profile().bindings.fingers);
    case Screen::Keys:
        paintVeil(canvas, faded(palette::kNight, 0.84f));
        return pages_.keys.draw(canvas, records_.profile().bindings);
    case Screen::Records:
        paintVeil(canvas, faded(palette::kNight, 0.84f));
        paintStatistics(canvas, records_.profile().totals);
        return menu_.draw(canvas);
    case Screen::Replays:
        return paintReplays(canvas, menu_, def_.replayFolder);
    case Screen::Help: // above
    case Screen::Editor:
    case Screen::Duel:
        return;
    case Screen::Playing:
        return paintPlaying(canvas, *this, question);
    case Screen::Paused:
        paintPaused(canvas, menu_, question, hudLookOf(*this), session().game().level());
        return paintNotices(canvas, reload_.notes(), kGameNotices);
    case Screen::BossCard:
        return paintBossCard(canvas, session().game().level(), over_.seconds);
    case Screen::Ending:
    case Screen::Over:
        return paintOver(canvas, *this);
    }
}

} // namespace apart
