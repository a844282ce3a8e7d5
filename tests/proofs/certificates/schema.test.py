"""Published JSON follows its schema, and the schema can tell.

usage: schema.test.py SCHEMA DOCUMENT
"""
import json
import sys

from jsonschema import Draft202012Validator

schema, document = (json.load(open(path, encoding="utf-8")) for path in sys.argv[1:])
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)
validator.validate(document)
for name in list(document):
    if name in schema["required"]:
        shorter = {key: value for key, value in document.items() if key != name}
        assert not validator.is_valid(shorter), f"accepted without {name}"
    if isinstance(document[name], list):
        emptied = {**document, name: [{**document[name][0], "unknown": 1}]}
        assert not validator.is_valid(emptied), f"accepted an unknown member in {name}"
assert not validator.is_valid({**document, "unknown": 1}), "accepted an unknown member"
