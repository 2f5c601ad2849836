"""The tables of a benchmark's report, as they stand in docs/benchmarks.md.

usage: bench_tables.py REPORT.json [SCENE...]
"""
import json
import sys


def cell(value):
    if value is None:
        return ""
    if isinstance(value, int):
        return f"{value:,}"
    if isinstance(value, float):
        return f"{value:.0f}" if abs(value) >= 1000 else f"{value:.3g}"
    return str(value)


def table(rows):
    columns = []
    for row in rows:
        columns += [name for name, value in row.items() if not isinstance(value, (dict, list)) and name not in columns]
    columns = [name for name in columns if name != "runs"]
    lines = [columns, ["---"] * len(columns)] + [[cell(row.get(name)) for name in columns] for row in rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        report = json.load(file)
    machine = report["machine"]
    print(f"commit {machine['commit']}, {machine.get('opengl', {}).get('renderer', machine['cpu'])}, {report['date']}")
    for scene, rows in report["scenes"].items():
        if rows and (scene in sys.argv[2:] or not sys.argv[2:]):
            print(f"\n{scene}\n\n{table(rows)}")


main()
