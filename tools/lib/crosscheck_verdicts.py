# SPDX-License-Identifier: MIT
"""Verdicts of the page of tools/crosscheck: each follows from the figures alone."""

BOX2D = 6  # the index of Box2D 2.4.1 in the plays: Kodo is before it, Box2D 3 after it, if built


def is_kodo(play):
    return not play["name"].startswith("Box2D")


def judged(figure, index):
    """(value, tolerance, holds) of a play; None where it does not play or is not judged."""
    result = figure["results"][index]
    if result is None or result["tolerance"] is None:
        return None
    return result["value"], result["tolerance"], result["holds"]


def score(scene, index):
    """How many of the judged figures of a play hold: (holding, judged)."""
    found = [one for one in (judged(f, index) for f in scene["figures"]) if one]
    return sum(holds for _, _, holds in found), len(found)


def verdict(scene):
    """(kind, words) from the figures. Box2D 2.4.1 must agree where the scene says so."""
    others = []
    for index, play in enumerate(scene["plays"]):
        good, all_of_them = score(scene, index)
        if good == all_of_them:
            continue
        if is_kodo(play):
            return "wrong", "does not hold"
        others.append(f'{play["name"]} differs in {all_of_them - good}')
    if any(f["rule"] == "exact" and not f["results"][BOX2D]["holds"] for f in scene["figures"]):
        return "wrong", "does not hold in Box2D 2.4.1"
    unjudged = any(f["rule"] != "show" and any(not judged(f, i) for i in range(BOX2D))
                   for f in scene["figures"])
    if others:
        return "differ", "Kodo holds; " + ", ".join(others)
    if unjudged:
        return "differ", "holds; thesis2006() is not judged in all figures"
    return "good", "all agree"


def nearer(scene):
    """Of the float plays, which is nearest to the closed forms: by twice and more than 1e-6."""
    wins = {}
    for figure in scene["figures"]:
        if figure["rule"] not in ("exact", "kodo"):
            continue
        errors = sorted(
            (abs(result["value"] - figure["exact"]), play["name"].split(",")[0])
            for result, play in zip(figure["results"], scene["plays"])
            if result and result["value"] is not None and not play["name"].endswith("double"))
        if len(errors) > 1 and errors[1][0] > max(1e-6 * max(1, abs(figure["exact"])), 2 * errors[0][0]):
            wins[errors[0][1]] = wins.get(errors[0][1], 0) + 1
    said = ", ".join(f"{name} in {count}" for name, count in sorted(wins.items(), key=lambda w: -w[1]))
    return f"Alone nearest to the closed form, by twice: {said}." if said else ""
