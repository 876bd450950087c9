# SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mouse over a picture in a notebook, with the widgets that every front end has.

Front ends of ipywidgets send no events of the mouse. They insert the text of an HTML widget into the page as it is, so
a transparent area over the picture has handlers of its own, and writes what they saw into the field of a hidden Text
widget, which the front end sends to the kernel. The text has totals since the page was loaded, so that a message that
is left out changes nothing.
"""
import ipywidgets

VIEW, FIELD = "tetmarch-view", "tetmarch-mouse"  # classes in the page

# Text fields of ipywidgets 6 react to "cut", those of 7 and 8 to "change". A wheel that counts lines: 33 pixels each.
HANDLER = (
    "var e=event,s=this.seen=this.seen||{page:Math.random(),x:0,y:0,wheel:0,down:false};"
    "if(e.type=='pointermove'){if(!s.down)return;s.x+=e.clientX-s.left;s.y+=e.clientY-s.top}"
    "else if(e.type=='wheel')s.wheel+=e.deltaY*(e.deltaMode?33:1);"
    "else{s.down=e.type=='pointerdown';if(s.down)this.setPointerCapture(e.pointerId)}"
    "s.left=e.clientX;s.top=e.clientY;"
    f"var field=this.closest('.{VIEW}').querySelector('.{FIELD} input');"
    "field.value=[s.page,s.x,s.y,s.wheel].join(' ');"
    "['cut','change'].forEach(function(type){field.dispatchEvent(new Event(type,{bubbles:true}))});"
    "return false")
EVENTS = "onpointerdown", "onpointermove", "onpointerup", "onpointercancel", "onwheel"


class Mouse(ipywidgets.VBox):
    """A widget of a fixed size, with the mouse over it.

    moved: called with (x, y, wheel): how far the mouse was dragged, in pixels, to the right and downwards, and how far
    its wheel was turned, in pixels as the browser counts them, since the last call.
    """

    def __init__(self, widget, width, height, moved):
        handlers = " ".join(f'{event}="{HANDLER}"' for event in EVENTS)
        area = ipywidgets.HTML(f'<div style="width:{width}px;height:{height}px;cursor:grab;touch-action:none" '
                               f'{handlers}></div>')
        area.layout = ipywidgets.Layout(width=f"{width}px", height=f"{height}px", margin=f"-{height}px 0 0 0")
        self.field = ipywidgets.Text(layout=ipywidgets.Layout(display="none"))
        self.field.add_class(FIELD)
        super().__init__([widget, area, self.field])
        self.layout.width, self.layout.overflow = f"{width + 4}px", "hidden"
        self.add_class(VIEW)
        self._moved = moved
        self._before = None, (0, 0, 0)  # the page, and its totals
        self.field.observe(self._told, names="value")

    def _told(self, change):
        page, *numbers = change["new"].split()
        totals = tuple(map(float, numbers))
        before = self._before[1] if page == self._before[0] else (0, 0, 0)
        self._before = page, totals
        self._moved(*(now - then for now, then in zip(totals, before)))
