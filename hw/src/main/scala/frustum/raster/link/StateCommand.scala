package frustum.raster.link

import frustum.contract.raster.{RasterConfig, RenderState, StoreLayout, StoredState, StoredStateLayout}
import frustum.raster.store.FieldBits._
import spinal.core._
import spinal.lib._

/** Executes `state`: refuses an index that does not exist and a state that differs from a constant of the hardware,
  * before anything of it is written. Where all of a state is constant nothing is written. The last words wait until
  * [[SentStates]] has found the state.
  */
case class StateCommand(config: RasterConfig, stored: StoredStateLayout = StoredState) extends Component {
  val layout = StoreLayout(config, stored)
  val io = new Bundle {
    val up = slave(GroupPort())
    val index = in UInt (log2Up(RenderState.Count) bits)
    val missing, found = in Bool () // see SentStates
    val sends = out Bool ()
    val writes = master(Stream(StoreWrite(layout)))
  }
  private val words = layout.stateWords
  val group = io.up.group

  /** Whether a word differs from what is constant of it. */
  private def differs(word: Int, data: Bits): Bool = {
    val wrong = for {
      (field, place) <- stored.of.toSeq if place.slice.word == word
      fixed = config.fixed(field) if fixed.mask != 0
    } yield (place.in(data) & B(fixed.mask, field.width bits)) =/= B(fixed.value, field.width bits)
    if (wrong.isEmpty) False else wrong.orR
  }

  io.up.refuse := group.first && io.missing
  io.sends := group.fire && group.last && !io.up.refuse
  if (words == 1) {
    val fits = !differs(0, group.words)
    io.writes.valid := group.valid && !group.first && fits && io.found && Bool(!config.fixed.whole)
    io.writes.address := StoreAddress.state(layout, io.index, U(0, 0 bits))
    io.writes.data := group.words
    group.ready := group.first || !fits || io.found && (io.writes.ready || Bool(config.fixed.whole))
    when(!group.first && !fits)(io.up.refuse := True)
  } else {
    // Earlier words are held until the last one, then written one after the other.
    val held = Vec.fill(words - 1)(Reg(Bits(32 bits)))
    val all = held :+ group.words
    val word = Reg(UInt(log2Up(words) bits))
    val fits = !(0 until words).map(w => differs(w, all(w))).orR
    val storing = group.valid && !group.first && group.last && fits
    val writing = storing && io.found && Bool(!config.fixed.whole)
    io.writes.valid := writing
    io.writes.address := StoreAddress.state(layout, io.index, word)
    io.writes.data := Vec(all)(word)
    val ends = if (config.fixed.whole) True else io.writes.ready && word === words - 1
    group.ready := group.first || !storing || io.found && ends
    when(!group.first && group.last && !fits)(io.up.refuse := True)
    when(group.fire) {
      word := 0
      for ((later, earlier) <- all.tail.zip(held)) earlier := later
    } elsewhen (io.writes.fire) { word := word + 1 }
  }
}
