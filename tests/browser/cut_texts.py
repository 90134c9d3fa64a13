"""Finds texts of a page that are cut off, at any of their four sides."""

WIDTHS = 1400, 420  # in pixels: a screen, a telephone

# A text is cut off if it reaches beyond a box that hides overflow (as a drawing does), or beyond the window's left or
# right edge. A scrolling box can show all of its texts, so only the box itself is checked. A line with an ellipsis is
# accepted: it shows that text is missing.
CUT_TEXTS = r"""
(() => {
  const cut = [], texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const isSeen = element => !element.closest("script, style, option") && element.checkVisibility();
  const sides = box => [box.left, box.top, box.right, box.bottom].map(Math.round).join(" ");
  const reachesBeyond = (box, outer, style) =>
    /hidden|clip/.test(style.overflowX) && style.textOverflow !== "ellipsis" && (box.left < outer.left - 1 || box.right > outer.right + 1) ||
    /hidden|clip/.test(style.overflowY) && (box.top < outer.top - 1 || box.bottom > outer.bottom + 1);
  const place = node => {
    const range = document.createRange();
    range.selectNodeContents(node);
    return range.getBoundingClientRect();
  };
  const seen = [];
  for (let node; (node = texts.nextNode());) {
    let box = place(node);
    if (!node.data.trim() || !box.width || !isSeen(node.parentElement)) continue;
    const text = node.data.trim();
    seen.push(text);
    for (let each = node.parentElement; each !== document.body; each = each.parentElement) {
      const style = getComputedStyle(each), outer = each.getBoundingClientRect();
      if (reachesBeyond(box, outer, style)) cut.push(`"${text}" at ${sides(box)} is cut off by ${each.tagName} at ${sides(outer)}`);
      if (/auto|scroll/.test(style.overflowX + style.overflowY)) box = outer;
    }
    if (box.left < -1 || box.right > innerWidth + 1) cut.push(`"${text}" at ${sides(box)} is cut off by a window of ${innerWidth}`);
  }
  return { seen, cut, width: innerWidth };
})()
"""


def check_nothing_is_cut(test, chromium, address, text):
    """Fails if a text of the page is cut off at either width; `text` must be among the visible texts."""
    for width in WIDTHS:
        with test.subTest(address=address, width=width):
            found, _ = chromium.value_in(address, CUT_TEXTS, width=width)
            test.assertEqual(found["width"], width)
            test.assertTrue(text in found["seen"], f"{text} is not on the page")
            test.assertEqual(found["cut"], [])
