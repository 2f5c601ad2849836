"""Drops files on a window as a file manager would: the source's side of the XDND protocol, version 5."""
import pathlib
import time

from Xlib import X, Xatom, display as xlib
from Xlib.protocol import event

from editor_driver import PATIENCE_S


class DropSource:
    def __init__(self, name):
        self.display = xlib.Display(name)
        self.root = self.display.screen().root
        self.window = self.root.create_window(0, 0, 1, 1, 0, X.CopyFromParent)
        self.uri_list = self.atom("text/uri-list")

    def atom(self, name):
        return self.display.intern_atom(name)

    def send(self, target, kind, data):
        message = event.ClientMessage(window=target, client_type=self.atom(kind), data=(32, [self.window.id, *data]))
        target.send_event(message, event_mask=0)
        self.display.flush()

    def answer(self, kind):
        """Serves the target's wish for the files until its message of this kind comes."""
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            if self.display.pending_events() == 0:
                time.sleep(0.01)
                continue
            got = self.display.next_event()
            if got.type == X.SelectionRequest:
                got.requestor.change_property(got.property, self.uri_list, 8, self.text)
                got.requestor.send_event(event.SelectionNotify(
                    time=got.time, requestor=got.requestor, selection=got.selection, target=got.target, property=got.property))
                self.display.flush()
            elif got.type == X.ClientMessage and got.client_type == self.atom(kind):
                return got.data[1]
        raise TimeoutError(f"no {kind} from the window")

    def drop(self, window_id, place, files):
        """`place`: in pixels of the screen."""
        target = self.display.create_resource_object("window", window_id)
        self.text = "".join(pathlib.Path(file).resolve().as_uri() + "\r\n" for file in files).encode()
        self.window.set_selection_owner(self.atom("XdndSelection"), X.CurrentTime)
        self.send(target, "XdndEnter", [5 << 24, self.uri_list, 0, 0])
        x, y = map(round, place)
        self.send(target, "XdndPosition", [0, x << 16 | y, X.CurrentTime, self.atom("XdndActionCopy")])
        if not self.answer("XdndStatus")[1] & 1:
            raise RuntimeError("the window takes no drop there")
        self.send(target, "XdndDrop", [0, X.CurrentTime, 0, 0])
        self.answer("XdndFinished")
