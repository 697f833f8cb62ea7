"""batch.html"""


def page_of(rows):
    return f"{len(rows)} rows\n"
