"""usage: page.py FILE: waits until the file contains the address of a page, and reads the page."""

import re
import sys
import time
import urllib.request

for _ in range(200):
    with open(sys.argv[1]) as file:
        found = re.search(r"http://\S+", file.read())
    if found:
        break
    time.sleep(0.1)
else:
    sys.exit("no address of a page")
with urllib.request.urlopen(found[0]) as answer:
    page = answer.read().decode()
assert "<title>" in page, page[:200]
print("the page:", re.search("<title>(.*?)</title>", page)[1])
