#!/usr/bin/env python3
"""Prints the table of docs/accuracy.md from the JSON files that tools/accuracy writes.

usage: accuracy_table.py FOLDER
"""
import json
import pathlib
import sys

# Names of the engines in the JSON, as tools/accuracy requests them, and their column headings.
NAMES = {
    "slicing:light.phase_display=physical:light.transport=low_albedo": "low albedo",
    "slicing:light.phase_display=physical:light.transport=translucent:light.form=printed":
        "translucent, as printed",
    "slicing:light.phase_display=physical:light.transport=translucent:light.form=consistent":
        "translucent, consistent",
    "march:light.transport=translucent": "march, translucent",
    "march:light.transport=full": "march, full",
}


def cell(image):
    """Bias in %, relRMSE in % and mean FLIP; relRMSE is null where it is not finite."""
    bias, rmse = 100 * image["bias"], image["rel_rmse"]
    text = "–" if rmse is None else f"{100 * rmse:.0f}"
    return f"{bias:+.1f} · {text} · {image['flip']['mean']:.2f}"


def main():
    files = sorted(pathlib.Path(sys.argv[1]).glob("*.json"))
    print("| view, sun (azimuth, elevation) | " + " | ".join(NAMES.values()) + " | noise |")
    print("|---|" + "---|" * (len(NAMES) + 1))
    for file in files:
        data = json.loads(file.read_text())
        case, view, azimuth, elevation = file.stem.split("-")
        images = {p["name"]: p for p in data["images"]}
        cells = [cell(images[name]) for name in NAMES]
        noise = 100 * next(iter(images.values()))["noise_taken_off"]
        print(f"| {case} {view}, {azimuth}°, {elevation}° | " + " | ".join(cells) + f" | {noise:.0f} |")


main()
