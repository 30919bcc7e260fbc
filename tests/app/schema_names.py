"""The keys that a JSON schema declares."""


def names_in(schema):
    """Returns the names of all keys in a schema."""
    inner = schema.values() if isinstance(schema, dict) else schema if isinstance(schema, list) else []
    own = set(schema.get("properties", {})) if isinstance(schema, dict) else set()
    return own.union(*map(names_in, inner))
