"""Which properties of a JSON schema a document has."""
from jsonschema import Draft202012Validator


def properties(schema, path=""):
    """The place of every named property that the schema has anywhere."""
    if isinstance(schema, dict):
        for key, value in schema.items():
            if key == "properties":
                yield from (f"{path}/{name}" for name in value)
                for name, part in value.items():
                    yield from properties(part, f"{path}/{name}")
            else:
                yield from properties(value, path if key in ("items", "oneOf") else f"{path}/{key}")
    elif isinstance(schema, list):
        for part in schema:
            yield from properties(part, path)


def used(schema, instance, root=None, path=""):
    """The places of the named properties that the instance has, as properties() writes them."""
    root = root or schema
    if "$ref" in schema:
        name = schema["$ref"].removeprefix("#/$defs/")
        yield from used(root["$defs"][name], instance, root, f"/$defs/{name}")
    for branch in schema.get("oneOf", []):
        if Draft202012Validator({**branch, "$defs": root.get("$defs", {})}).is_valid(instance):
            yield from used(branch, instance, root, path)
    if isinstance(instance, list) and "items" in schema:
        for part in instance:
            yield from used(schema["items"] or {}, part, root, path)
    if isinstance(instance, dict):
        named = schema.get("properties", {})
        for key, value in instance.items():
            if key in named:
                yield f"{path}/{key}"
                yield from used(named[key], value, root, f"{path}/{key}")
            elif isinstance(schema.get("additionalProperties"), dict):
                yield from used(schema["additionalProperties"], value, root, f"{path}/additionalProperties")
