"""Every shipped scenario, rig and playlist fits the JSON Schema that its first line names."""

import pathlib
import sys
import tomllib

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)

import json

config = pathlib.Path(sys.argv[1])
files = sorted(config.glob("scenarios/*.toml")) + sorted(config.glob("rigs/*.toml"))
files += sorted(config.glob("playlists/*.toml"))
assert files, "no shipped files found"
for file in files:
    text = file.read_text()
    first = text.splitlines()[0]
    assert first.startswith("#:schema "), f"{file}: the first line names no schema"
    schema = json.loads((file.parent / first.removeprefix("#:schema ")).read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    jsonschema.validate(tomllib.loads(text), schema, cls=jsonschema.Draft7Validator)
    misspelt = tomllib.loads(text) | {"titel": "x"}
    assert not jsonschema.Draft7Validator(schema).is_valid(misspelt), f"{file}: the schema lets unknown keys pass"
    print(f"{file.name} fits")

# What no shipped rig has: the keys of a wall's projector, right and wrong.
rig = tomllib.loads((config / "rigs/desk.toml").read_text())
schema = jsonschema.Draft7Validator(json.loads((config / "rig.schema.json").read_text()))
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
scenario = jsonschema.Draft7Validator(json.loads((config / "scenario.schema.json").read_text()))
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
