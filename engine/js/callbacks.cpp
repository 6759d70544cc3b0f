// SPDX-License-Identifier: MIT
// Functions of JavaScript that the engine calls: fields of the user, and figures of kodo_draw().
// They are imports of the module, by which a pointer to one is an ordinary function pointer.
#include <kodo.h>

#define KODO_JS_IMPORT(name) __attribute__((import_module("kodo"), import_name(name)))
#define KODO_JS_EXPORT __attribute__((used, visibility("default")))

extern "C" {

KODO_JS_IMPORT("field")
void kodo_js_field(void* context, const kodo_FieldBody* body, kodo_Real dt, kodo_FieldForce* force);
KODO_JS_IMPORT("line")
void kodo_js_line(void* context, kodo_Vec2 from, kodo_Vec2 to, const kodo_DrawStyle* style);
KODO_JS_IMPORT("circle")
void kodo_js_circle(void* context, kodo_Vec2 center, kodo_Real radius, const kodo_DrawStyle* style);
KODO_JS_IMPORT("polygon")
void kodo_js_polygon(void* context, const kodo_Vec2* corners, size_t count,
                     const kodo_DrawStyle* style);
KODO_JS_IMPORT("text")
void kodo_js_text(void* context, kodo_Vec2 middle, const char* utf8, const kodo_DrawStyle* style);

/// Makes a field call the function of JavaScript with this number.
KODO_JS_EXPORT void kodo_js_setField(kodo_OwnField* own, void* number, bool steady) {
    own->at = kodo_js_field;
    own->destroy = nullptr;
    own->context = number;
    own->steady = steady;
}

KODO_JS_EXPORT void* kodo_js_numberOf(const kodo_OwnField* own) {
    return own->context;
}

/// Makes a picture call the functions of JavaScript.
KODO_JS_EXPORT void kodo_js_setFigures(kodo_DebugDraw* target) {
    target->line = kodo_js_line;
    target->circle = kodo_js_circle;
    target->polygon = kodo_js_polygon;
    target->text = kodo_js_text;
}

} // extern "C"
