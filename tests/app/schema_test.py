"""schema_test.py CONFIG SCHEMAS: every shipped scenario, rig, playlist, study and item bank fits the JSON Schema that its first line
names; the schemas are those that the build has made."""

import datetime
import pathlib
import re
import sys
import tomllib

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)

import json

from schema_names import names_in


def with_dates_as_texts(table):
    """Returns the file as a schema sees it: JSON has no dates."""
    return {key: value.isoformat() if isinstance(value, datetime.date) else value for key, value in table.items()}


config, schemas = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
files = sorted(config.glob("scenarios/*.toml")) + sorted(config.glob("rigs/*.toml"))
files += sorted(config.glob("playlists/*.toml")) + sorted(config.glob("studies/*.toml"))
assert files, "no shipped files found"
for file in files:
    text = file.read_text()
    first = text.splitlines()[0]
    assert first.startswith("#:schema "), f"{file}: the first line names no schema"
    schema = json.loads((schemas / first.removeprefix("#:schema ../")).read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    jsonschema.validate(with_dates_as_texts(tomllib.loads(text)), schema, cls=jsonschema.Draft7Validator)
    misspelt = with_dates_as_texts(tomllib.loads(text)) | {"titel": "x"}
    assert not jsonschema.Draft7Validator(schema).is_valid(misspelt), f"{file}: the schema lets unknown keys pass"
    print(f"{file.name} fits")

# What no shipped rig has: the keys of a wall's projector, right and wrong.
rig = tomllib.loads((config / "rigs/desk.toml").read_text())
schema = jsonschema.Draft7Validator(json.loads((schemas / "rig.schema.json").read_text()))
for values, right in [
    ({"warp": "a.pfm", "blend": "b.png", "black_level": 0.1, "flip": "both", "display_latency_ms": 5}, True),
    ({"warp": "a.txt"}, False),
    ({"blend": "b.obj"}, False),
    ({"black_level": 1.1}, False),
    ({"flip": True}, False),
    ({"upper_right": [1, 2, 3], "skewed": True}, True),
    ({"skewed": 1}, False),
    ({"gain": [1.0, 0.9, 0.8], "gamma": [2.2, 2.2, 2.3]}, True),
    ({"gain": [1.0, 0.9]}, False),
    ({"gain": [1.0, 0.9, 1.2]}, False),
    ({"gamma": 2.2}, False),
    ({"warp_red": "r.obj", "warp_green": "g.obj", "warp_blue": "b.pfm"}, True),
    ({"warp_red": "r.png"}, False),
]:
    tried = rig | {"wall": [rig["wall"][0] | values]}
    assert schema.is_valid(tried) == right, f"the schema judges {values} wrongly"
print("the keys of a projector are judged rightly")

for window, right in [
    ({"monitor": "DP-1", "border": True}, True),
    ({"monitor": ["DP-1", "DP-3"], "fullscreen": True}, True),
    ({"monitor": 1}, True),
    ({"monitor": []}, False),
    ({"monitor": -1}, False),
    ({"monitor": [0, 1]}, False),
    ({"border": 1}, False),
]:
    tried = rig | {"wall": [rig["wall"][0] | {"window": {"size": [640, 480]} | window}]}
    assert schema.is_valid(tried) == right, f"the schema judges the window {window} wrongly"
print("the keys of a window are judged rightly")

game = tomllib.loads((config / "scenarios/three-pucks.toml").read_text())
puck = {"name": "a", "mass_kg": 1, "position_m": [0, 0], "beta": [0, 0]}
scenario = jsonschema.Draft7Validator(json.loads((schemas / "scenario.schema.json").read_text()))
for keys, right in [
    ({"radius_m": 0.1}, True),
    ({"outline_m": [[0, 0], [1, 0], [0, 1]]}, True),
    ({"outline_m": [[0, 0], [1, 0]]}, False),
    ({"outline_m": [[0, 0], [1, 0], [0, 1]], "radius_m": 0.1}, False),
    ({"radius_m": 0.1, "mesh": "a.obj", "outline": "mesh"}, True),
    ({"radius_m": 0.1, "outline": "mesh"}, False),
    ({"radius_m": 0.1, "mesh": "a.obj", "outline": "hull"}, False),
]:
    assert scenario.is_valid(game | {"puck": [puck | keys]}) == right, f"the schema judges the puck {keys} wrongly"
print("the keys of outlines are judged rightly")

for node, right in [
    ({"rank": 0, "host": "cave-front"}, True),
    ({"rank": 0, "host": "10.0.0.7", "slots": 2, "display": ":0.1"}, True),
    ({"rank": 0, "display": ":0"}, True),
    ({"rank": 0}, False),
    ({"rank": 0, "host": "-x"}, False),
    ({"rank": 0, "host": "a", "slots": 0}, False),
]:
    assert schema.is_valid(rig | {"node": [node]}) == right, f"the schema judges the node {node} wrongly"
for start, right in [
    ({"network": "10.0.0.0/24", "environment": ["A=b c", "XAUTHORITY"]}, True),
    ({"network": "a b"}, False),
    ({"environment": ["=b"]}, False),
]:
    assert schema.is_valid(rig | {"start": start}) == right, f"the schema judges [start] {start} wrongly"
print("the keys of nodes and their start are judged rightly")

rig_keys, scenario_keys, playlist_keys = (
    json.loads((schemas / f"{kind}.schema.json").read_text()) for kind in ["rig", "scenario", "playlist"]
)


# Each key in an example of a page is one that there is; and these are the defaults, where an example says so.
for page, names in [
    ("rigs.md", names_in(rig_keys)),
    ("scenarios.md", names_in(scenario_keys)),
    ("teachers.md", names_in(scenario_keys)),
    ("operators.md", names_in([rig_keys, playlist_keys])),
    ("studies.md", names_in([json.loads((schemas / f"{kind}.schema.json").read_text()) for kind in ("study", "items")])),
]:
    text = (config.parent / "app/doc" / page).read_text()
    given = set()
    for example in re.findall(r"(?ms)^```toml\n(.*?)^```$", text):
        code = re.sub(r'"[^"\n]*"', '""', re.sub(r"(?m)#.*$", "", example))
        given |= set(re.findall(r"(?m)(?:^|[{,])\s*(\w+) =", code)) | set(re.findall(r"(?m)^\[+(?:\w+\.)*(\w+)\]", code))
    assert given, f"{page} has no example"
    assert given <= names, f"{page}: its examples have keys that there are not: {sorted(given - names)}"
    print(f"the {len(given)} keys in examples of {page} are there")

example = re.search(r"(?ms)^\[physics\].*?$(.*?)\n\n", (config.parent / "app/doc/scenarios.md").read_text())[1]
defaults = scenario_keys["properties"]["physics"]["properties"]
assert tomllib.loads(example) == {name: key["default"] for name, key in defaults.items()}, "other defaults of [physics]"
example = re.search(r"(?ms)^\[observer\]$(.*?)^```", (config.parent / "app/doc/scenarios.md").read_text())[1]
for name, key in scenario_keys["properties"]["observer"]["properties"].items():
    assert name in ("beta", "fastest_beta") or tomllib.loads(example)[name] == key["default"], f"another default of {name}"
print("the defaults of [physics] and [observer] are those that scenarios.md gives")
