"""Sealed labels of a blind trial: whoever has the experiments has a digest of each label, and the labels stand elsewhere."""
import hashlib
import json


def sha256(text):
    return hashlib.sha256(text.encode()).hexdigest()


def new_folders(parent, trial, seed):
    """Of the experiments, and of their labels."""
    folders = parent / f"{trial}-{seed}", parent / f"{trial}-{seed}-labels"
    for folder in folders:
        folder.mkdir(parents=True)
    return folders


def sealed(labels, name, seed, label):
    """Writes a label, a text, in an envelope with a salt. Returns the name and the seal."""
    envelope = {"salt": sha256(f"{seed}\n{name}")[:32], "label": label}
    (labels / f"{name}.json").write_text(json.dumps(envelope, indent=1) + "\n")
    return name, sha256(envelope["salt"] + "\n" + envelope["label"])


def write_seals(out, seals):
    text = json.dumps({"format": "experiment-seals/1", "seals": seals}, indent=1) + "\n"
    (out / "seals.json").write_text(text)
    print(f"{len(seals)} experiments in {out}; SHA-256 of the seals: {sha256(text)}")
