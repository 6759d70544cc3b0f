// SPDX-License-Identifier: MIT
#include "imgui_host.hpp"

#include <backends/imgui_impl_opengl2.h>

#include <array>
#include <imgui.h>
#include <utility>

namespace destructoooor {

namespace {

constexpr float kTextHeight = 15; // pixels

using Key = sf::Keyboard::Key;
constexpr std::array<std::pair<ImGuiKey_, Key>, 16> kKeys = {{{ImGuiKey_Tab, Key::Tab},
                                                              {ImGuiKey_LeftArrow, Key::Left},
                                                              {ImGuiKey_RightArrow, Key::Right},
                                                              {ImGuiKey_UpArrow, Key::Up},
                                                              {ImGuiKey_DownArrow, Key::Down},
                                                              {ImGuiKey_PageUp, Key::PageUp},
                                                              {ImGuiKey_PageDown, Key::PageDown},
                                                              {ImGuiKey_Home, Key::Home},
                                                              {ImGuiKey_End, Key::End},
                                                              {ImGuiKey_Delete, Key::Delete},
                                                              {ImGuiKey_Backspace, Key::Backspace},
                                                              {ImGuiKey_Space, Key::Space},
                                                              {ImGuiKey_Enter, Key::Enter},
                                                              {ImGuiKey_Escape, Key::Escape},
                                                              {ImGuiKey_A, Key::A},
                                                              {ImGuiKey_C, Key::C}}};

void setKey(Key key, bool down) {
    if (key >= 0 && key < Key::KeyCount) {
        ImGui::GetIO().KeysDown[key] = down;
    }
}

} // namespace

ImGuiHost::ImGuiHost(const std::string& fontFile) {
    ImGui::CreateContext();
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // places of panels are fixed
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.Fonts->AddFontFromFileTTF(fontFile.c_str(), kTextHeight);
    for (const auto& [name, key] : kKeys) {
        io.KeyMap[name] = key;
    }
    ImGui_ImplOpenGL2_Init();
}

ImGuiHost::~ImGuiHost() {
    ImGui_ImplOpenGL2_Shutdown();
    ImGui::DestroyContext();
}

void ImGuiHost::take(const sf::Event& event) {
    ImGuiIO& io = ImGui::GetIO();
    switch (event.type) {
    case sf::Event::MouseMoved:
        io.MousePos = {static_cast<float>(event.mouseMove.x),
                       static_cast<float>(event.mouseMove.y)};
        break;
    case sf::Event::MouseButtonPressed:
    case sf::Event::MouseButtonReleased:
        io.MousePos = {static_cast<float>(event.mouseButton.x),
                       static_cast<float>(event.mouseButton.y)};
        if (event.mouseButton.button < 3) { // left, right, middle, as in ImGui
            io.MouseDown[event.mouseButton.button] = event.type == sf::Event::MouseButtonPressed;
        }
        break;
    case sf::Event::MouseWheelScrolled:
        io.MouseWheel += event.mouseWheelScroll.delta;
        break;
    case sf::Event::KeyPressed:
    case sf::Event::KeyReleased:
        setKey(event.key.code, event.type == sf::Event::KeyPressed);
        io.KeyCtrl = event.key.control;
        io.KeyShift = event.key.shift;
        break;
    case sf::Event::TextEntered:
        io.AddInputCharacter(event.text.unicode);
        break;
    case sf::Event::LostFocus:
        for (int key = 0; key < Key::KeyCount; ++key) {
            setKey(static_cast<Key>(key), false);
        }
        break;
    default:
        break;
    }
}

void ImGuiHost::begin(kodo_sfml::Size pixels, float seconds) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(pixels.x), static_cast<float>(pixels.y)};
    io.DeltaTime = seconds > 0 ? seconds : 1e-3f;
    ImGui_ImplOpenGL2_NewFrame();
    ImGui::NewFrame();
}

void ImGuiHost::draw() {
    ImGui::Render();
    ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
}

bool ImGuiHost::wantsMouse() const {
    return ImGui::GetIO().WantCaptureMouse;
}
bool ImGuiHost::wantsKeys() const {
    return ImGui::GetIO().WantTextInput;
}

} // namespace destructoooor
