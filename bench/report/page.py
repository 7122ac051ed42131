"""Writes comparison.html beside a raw.json of `rayshoot bench`: tables and plots in one file."""

import json
import sys
from pathlib import Path

import altair
import jinja2
import pandas
import vl_convert

HERE = Path(__file__).parent


def rows_of(document):
    """One line per row that was timed, with its rate and interval in Mrays/s."""
    lines = []
    for row in document["rows"]:
        rate = row["mrays_per_second"]
        per_ray = row.get("per_ray") or {}
        lines.append(
            {
                "name": row["name"],
                "scene": row["scene"],
                "structure": row["structure"],
                "kind": row["kind"],
                "sampled": bool(row.get("sampled")),
                "median": rate["median"],
                "low": rate["low"],
                "high": rate["high"],
                "ratio": row["ratio_to_embree"]["median"],
                "best_ratio": row.get("ratio_to_best_embree", {}).get("median"),
                "object_tests": per_ray.get("object_tests"),
                "volume_tests": per_ray.get("bounding_volume_tests"),
                "steps": per_ray.get("steps"),
                "build_ms": None if row["build_seconds"] is None else 1e3 * row["build_seconds"],
                "error": row.get("error"),
                "refusal": row.get("refusal"),
            }
        )
    return pandas.DataFrame(lines)


def rate_chart(rows):
    """Medians with their intervals, on a logarithmic axis; one panel per ray kind."""
    timed = rows.dropna(subset=["median"])
    if timed.empty:
        return None
    base = altair.Chart(timed).encode(
        y=altair.Y("structure:N", title=None),
        color=altair.Color("structure:N", legend=None),
    )
    median = base.mark_point(filled=True).encode(
        x=altair.X("median:Q", title="Mrays/s", scale=altair.Scale(type="log"))
    )
    interval = base.mark_rule().encode(x="low:Q", x2="high:Q")
    return (
        altair.layer(interval, median)
        .properties(width=180, height=16 * timed["structure"].nunique())
        .facet(row=altair.Row("scene:N", title=None), column=altair.Column("kind:N", title=None))
    )


def cell(value):
    """n/a for what was not measured, else four significant digits."""
    if value is None or pandas.isna(value):
        return "n/a"
    if isinstance(value, str):
        return value
    return f"{value:.4g}" if abs(value) < 1e4 else f"{value:,.0f}"


def page(document):
    rows = rows_of(document)
    chart = rate_chart(rows) if len(rows) else None
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(HERE), autoescape=True, undefined=jinja2.StrictUndefined
    )
    environment.filters["cell"] = cell
    return environment.get_template("page.html.jinja").render(
        provenance=document.get("provenance", {}),
        settings=document.get("settings", {}),
        noise=document.get("machine_noise", {}),
        control={"moved": None, "void": None, **document.get("control", {})},
        adaptor=document.get("embree_adaptor", []),
        rows=rows.astype(object).where(rows.notna(), None).to_dict("records"),
        svg=vl_convert.vegalite_to_svg(chart.to_json()) if chart else "",
    )


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: page.py RAW.json")
    raw = Path(sys.argv[1])
    try:
        document = json.loads(raw.read_text(encoding="utf-8"))
    except (OSError, ValueError) as wrong:
        sys.exit(f"page.py: {raw}: {wrong}")
    known = isinstance(document, dict) and document.get("schema") == 1
    if not known or "rows" not in document:
        sys.exit(f"page.py: {raw}: no comparison as `rayshoot bench --out` writes it")
    target = raw.with_name("comparison.html")
    target.write_text(page(document), encoding="utf-8")
    print(f"written to {target}")


if __name__ == "__main__":
    main()
