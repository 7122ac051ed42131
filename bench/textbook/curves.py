"""Draws the curves of `rayshoot textbook` in a folder: each CSV that charts.json names, as an SVG."""

import json
import sys
from pathlib import Path

import altair
import pandas
import vl_convert

WIDTH, HEIGHT = 640, 240  # pixels


def drawing(points, chart):
    """Lines and points of one frame, coloured by series in the order of the file."""
    order = list(dict.fromkeys(points["series"]))
    base = altair.Chart(points).encode(
        x=altair.X("x:Q", title=chart["x"], scale=altair.Scale(nice=False)),
        y=altair.Y("y:Q", title=chart["y"]),
        color=altair.Color(
            "series:N",
            sort=order,
            title=None,
            legend=altair.Legend(orient="top") if len(order) > 1 else None,
        ),
        order=altair.Order("x:Q"),
    )
    lines = base.transform_filter("datum.mark == 'line'").mark_line(strokeWidth=1.2)
    dots = base.transform_filter("datum.mark == 'points'").mark_point(filled=True, size=30)
    return altair.layer(lines, dots).properties(width=WIDTH, height=HEIGHT)


def draw(folder, chart):
    points = pandas.read_csv(folder / f"{chart['name']}.csv")
    # The test function has more points than Altair takes without being told.
    with altair.data_transformers.enable("default", max_rows=None):
        svg = vl_convert.vegalite_to_svg(drawing(points, chart).to_json())
    target = folder / f"{chart['name']}.svg"
    target.write_text(svg, encoding="utf-8")
    return target


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: curves.py FOLDER")
    folder = Path(sys.argv[1])
    try:
        document = json.loads((folder / "charts.json").read_text(encoding="utf-8"))
    except (OSError, ValueError) as wrong:
        sys.exit(f"curves.py: {folder}: {wrong}; `rayshoot textbook --out {folder}` writes it")
    if not isinstance(document, dict) or document.get("schema") != 1:
        sys.exit(f"curves.py: {folder}/charts.json: not as `rayshoot textbook` writes it")
    for chart in document["charts"]:
        print(f"written to {draw(folder, chart)}")


if __name__ == "__main__":
    main()
